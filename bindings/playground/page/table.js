// SPDX-License-Identifier: GPL-3.0-or-later
// The answers side by side. What differs from the certified answer is marked by a sign and a colour.

const KEYS = [
  ["contact", "contact"], ["relation", "relation"], ["plane", "plane"], ["plane_tangent", "tangent to the plane"], ["foot", "foot"],
  ["edges_hit", "edges hit"], ["nearest", "nearest"], ["distance", "distance"], ["point", "closest point"],
  ["contact_normal", "contact normal"], ["depth", "depth"], ["off_plane", "off the plane"],
];

function wordsOf(value) {
  if (value === undefined) return "–";
  if (typeof value === "boolean") return value ? "yes" : "no";
  if (Array.isArray(value)) return value.length ? value.join(", ") : "none";
  if (value && typeof value === "object") return value.kind === "face" ? "face" : `${value.kind} ${value.index}`;
  return String(value).replace("_", " ");
}

function differs(value, certified) {
  return value !== undefined && JSON.stringify(value) !== JSON.stringify(certified);
}

/// Fills the table with the answers by method.
function showAnswers(body, answers) {
  body.replaceChildren(...KEYS.map(([key, words]) => {
    const row = document.createElement("tr"), head = document.createElement("th");
    head.scope = "row", head.textContent = words;
    row.append(head, ...METHODS.map((method) => {
      const cell = document.createElement("td"), wrong = differs(answers[method][key], answers.filtered[key]);
      cell.dataset.method = method, cell.dataset.key = key;
      cell.textContent = (wrong ? "≠ " : "") + wordsOf(answers[method][key]);
      cell.classList.toggle("differs", wrong);
      cell.classList.toggle("number", ["distance", "point", "contact_normal", "depth", "off_plane"].includes(key));
      return cell;
    }));
    return row;
  }));
}

/// Returns who differs about contact and foot, in a sentence.
function summaryOf(answers) {
  const wrong = (method) => ["contact", "foot"].filter((key) => differs(answers[method][key], answers.filtered[key]));
  const say = (method) => wrong(method).length ? `${method} differs in ${wrong(method).join(" and ")}` : `${method} agrees`;
  return `Certified: ${answers.filtered.relation}, foot ${answers.filtered.foot}, decided in stage ${answers.filtered.stage}. ` +
    `On contact and foot, ${say("fast")}, ${say("thesis")}; exact ${differs({...answers.exact, stage: 0}, {...answers.filtered, stage: 0}) ? "DIFFERS" : "agrees"}.`;
}
