# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: engine_action.py BUILD SOURCE SCRATCH

What judges an engine in someone's CI: the action of .github/actions/judge, the workflow and the template of GitLab. All
files for CI are YAML with scripts that bash reads. The steps of the action run here as they stand, on an archive of the
program of BUILD: they fail for an engine that errs, pass if that is known, and leave the results.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import unittest

import yaml

BUILD, SOURCE, SCRATCH = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
GITHUB = SOURCE / ".github"
ACTION = yaml.safe_load((GITHUB / "actions/judge/action.yml").read_text())
WORKFLOW = yaml.safe_load((GITHUB / "workflows/judge-engine.yml").read_text())
TEMPLATE = yaml.safe_load((SOURCE / ".gitlab/judge-engine.yml").read_text())[".judge-engine"]
SCRIPT = (SOURCE / ".ci/judge_engine").read_text()
ARCHIVE, FOLDER = SCRATCH / "touchstone-0-any.tar.gz", "touchstone-0-any"


def scripts(value):
    """The scripts below a value of a file for CI."""
    if isinstance(value, list):
        return [script for entry in value for script in scripts(entry)]
    if not isinstance(value, dict):
        return []
    found = [value["run"]] if "run" in value else []
    for key in "before_script", "script":
        found += value.get(key, [])
    return found + scripts(list(value.values()))


class Files(unittest.TestCase):
    def test_every_file_is_YAML_with_scripts_that_bash_reads(self):
        count = 0
        for file in [*GITHUB.rglob("*.yml"), *(SOURCE / ".gitlab").rglob("*.yml")]:
            for script in scripts(yaml.safe_load(file.read_text())):
                script = re.sub(r"\$\{\{.*?\}\}", "value", script)
                done = subprocess.run(["bash", "-n", "-c", script], capture_output=True, text=True)
                self.assertEqual((done.returncode, done.stderr), (0, ""), f"{file}: {script}")
                count += 1
        self.assertGreater(count, 10)

    def test_the_workflow_passes_the_inputs_of_the_action(self):
        inputs = WORKFLOW[True]["workflow_call"]["inputs"]  # YAML 1.1 reads `on` as true
        step, = (step for step in WORKFLOW["jobs"]["judge"]["steps"] if "actions/judge" in step.get("uses", ""))
        self.assertEqual(step["uses"], "./.touchstone/.github/actions/judge")
        self.assertEqual(set(step["with"]), set(ACTION["inputs"]) - {"folder"})
        self.assertEqual(set(inputs), set(step["with"]) | {"touchstone", "ref", "packages", "build"})
        for name, value in step["with"].items():
            self.assertEqual(value, f"${{{{ inputs.{name} }}}}")
            self.assertEqual(inputs[name].get("default"), ACTION["inputs"][name].get("default"), name)

    def test_the_action_and_the_template_set_what_the_script_reads(self):
        read = set(re.findall(r"\$\{([A-Z]+):-", SCRIPT)) - {"TOUCHSTONE", "TIME_LIMIT"}
        self.assertEqual(set(ACTION["runs"]["steps"][1]["env"]), read | {"ENGINE", "FOLDER"})
        self.assertLessEqual(read, set(TEMPLATE["variables"]))


class Action(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(SCRATCH, ignore_errors=True)
        SCRATCH.mkdir(parents=True)
        subprocess.run(["cmake", "--install", BUILD, "--prefix", SCRATCH / FOLDER, "--component", "program"], check=True, stdout=subprocess.DEVNULL)
        with tarfile.open(ARCHIVE, "w:gz", compresslevel=1) as archive:
            archive.add(SCRATCH / FOLDER, FOLDER)
        page = (SOURCE / "docs/engines.md").read_text()
        (SCRATCH / "engine.py").write_text(re.search(r"```python\n(.*?)```", page, re.DOTALL)[1])
        cls.addClassCleanup(shutil.rmtree, SCRATCH)

    def run_steps(self, **given):
        """The exit status of the first step that fails, and what the steps printed."""
        work = SCRATCH / "work"
        shutil.rmtree(work, ignore_errors=True)
        (work / "temp").mkdir(parents=True)
        inputs = {name: entry.get("default", "") for name, entry in ACTION["inputs"].items()}
        inputs |= {"engine": f"python3 {SCRATCH}/engine.py=vertices", "moving": "no", "floats": "yes", "keys": "contact", "beyond": "2^-20"} | given
        environment = {"PATH": os.environ["PATH"], "RUNNER_TEMP": f"{work}/temp", "GITHUB_STEP_SUMMARY": f"{work}/summary.md"}
        said = ""
        for step in ACTION["runs"]["steps"]:
            variables = {key: re.sub(r"\$\{\{ inputs\.(\w+) \}\}", lambda found: inputs[found[1]], value) for key, value in step["env"].items()}
            done = subprocess.run(["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c", step["run"]], cwd=work, env=environment | variables,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            said += done.stdout
            if done.returncode != 0:
                return done.returncode, said
        return 0, said

    def test_fails_for_an_engine_that_errs_and_leaves_the_results(self):
        status, said = self.run_steps(archive=str(ARCHIVE))
        self.assertEqual(status, 1, said)
        self.assertIn("vertices", (SCRATCH / "work/summary.md").read_text())
        for file in "summary.txt", "junit.xml", "report.html":
            self.assertTrue((SCRATCH / "work/judged" / file).exists(), file)

    def test_passes_if_the_failures_are_known(self):
        known = SCRATCH / "known.jsonl"
        corpus = SCRATCH / FOLDER / "share/touchstone/tests/corpus/floats"
        subprocess.run([SCRATCH / FOLDER / "bin/touchstone", "judge", "--engine", f"python3 {SCRATCH}/engine.py=vertices", "--at-rest", "--keys", "contact",
                        "--beyond", "2^-20", "--known", known, "--update", "--summary", *sorted(corpus.glob("*.jsonl"))],
                       check=True, stdout=subprocess.DEVNULL)
        status, said = self.run_steps(archive=ARCHIVE.as_uri(), known=str(known))
        self.assertEqual(status, 0, said)

    def test_fails_without_an_archive(self):
        for archive in f"{ARCHIVE}.none", f"{ARCHIVE.as_uri()}.none":
            self.assertNotEqual(self.run_steps(archive=archive)[0], 0)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
