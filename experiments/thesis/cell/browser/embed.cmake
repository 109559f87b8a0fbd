# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DFOLDER=page -DOUTPUT=page_sources.cpp -P embed.cmake: the files of a folder as texts of a program.
file(GLOB files ${FOLDER}/*)
set(texts "")
foreach(file ${files})
  get_filename_component(name ${file} NAME)
  file(READ ${file} text)
  string(APPEND texts "      {\"${name}\", R\"page(${text})page\"},\n")
endforeach()
file(WRITE ${OUTPUT} "// Written by embed.cmake.
#include \"experiments/thesis/cell/browser/page.h\"

#include <map>

namespace touchstone::cell::browser {

std::string_view page_source(std::string_view name) {
  static const std::map<std::string_view, std::string_view> sources{
${texts}  };
  return sources.at(name);
}

}  // namespace touchstone::cell::browser
")
