#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Runs the recipes of docs/ci on a folder of recordings, with the commands that stand in them.

    tests/apps/ci_recipes.py SOFTCNC

The commands of github.yml and gitlab.yml are taken out of these files as their services take them,
and run in the shells of the services with the variables that those set; parallel.sh and slurm.sh are
run as they are. Neither GitHub nor GitLab nor Slurm is there: of Slurm, the script runs once for each
task of its array, with the variables that sbatch sets. Nothing is installed: in the jobs of GitHub and
GitLab an apt-get of this test puts softcnc on the PATH if the package that it is given exists. Each recipe
must replay every recording exactly once and pass; and fail, with a failure in its JUnit XML, when one of
the recordings has been changed.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree
import zipfile

import yaml

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
RECIPES = ROOT / "docs/ci"
SQUARE = ROOT / "tests/apps/data/square.nc"
RECORDINGS = 7
APT_GET = """#!/bin/bash
[[ $1 == update ]] || { [[ $1 == install && -f ${*: -1} ]] && ln -s "$SOFTCNC" "${0%/*}/softcnc"; }
"""


def run(command, folder, **variables):
    """Runs a command in a folder; returns its exit status."""
    ended = subprocess.run(command, cwd=folder, stdin=subprocess.DEVNULL, env={**ENVIRONMENT, **variables},
                           stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=300)
    if ended.returncode not in (0, 1):
        sys.exit(f"{command}: status {ended.returncode}\n{ended.stdout.decode()}")
    return ended.returncode


def make_folder(folder):
    """A project as the recipes expect it: recordings, a part, and the trace that is kept of it."""
    for name in ("recordings/below", "parts", "traces", "packages"):
        (folder / name).mkdir(parents=True)
    (folder / "packages/softcnc_0.1.0-1_amd64.deb").touch()
    for i in range(RECORDINGS):
        part = folder / f"{i}.nc"
        part.write_text(f"G01 X{i + 1} F{600 + 100 * i}\nM30\n")
        to = folder / "recordings" / ("below" if i % 2 else "") / f"{i}.rec"
        assert run(["softcnc", "record", "-q", part, "-o", to], folder) == 0
    shutil.copy(SQUARE, folder / "parts/part.nc")
    trace = folder / "traces/part.csv.zst"
    assert run(["softcnc", "run", "-q", "--dry-run", folder / "parts/part.nc", "--trace", trace], folder) == 0


def change(folder):
    """Changes one recording, and the part whose trace is kept, so that both differ."""
    file = folder / "recordings/below/3.rec"
    with zipfile.ZipFile(file) as archive:
        entries = [(name, archive.read(name)) for name in archive.namelist()]
    with zipfile.ZipFile(file, "w") as archive:
        for name, content in entries:
            if name == "trace.csv.zst":
                rows = subprocess.run(["zstd", "-dc"], input=content, stdout=subprocess.PIPE, check=True).stdout
                lines = rows.decode().splitlines()
                cells = lines[30].split(",")
                cells[7] = str(float(cells[7]) + 0.001)  # x_mm
                lines[30] = ",".join(cells)
                rows = "".join(line + "\n" for line in lines).encode()
                content = subprocess.run(["zstd", "-c"], input=rows, stdout=subprocess.PIPE, check=True).stdout
            archive.writestr(name, content)
    part = folder / "parts/part.nc"
    part.write_text(re.sub(r"F\d+", "F300", part.read_text()))


def bare(folder):
    """The variables of a job that begins without softcnc."""
    tools = folder / "tools"
    shutil.rmtree(tools, ignore_errors=True)
    tools.mkdir()
    (tools / "apt-get").write_text(APT_GET)
    (tools / "apt-get").chmod(0o755)
    return {"PATH": f"{tools}{os.pathsep}{os.environ['PATH']}", "SOFTCNC": str(SOFTCNC)}


def github(folder):
    """The exit status of each job of the workflow, by the rules of GitHub Actions."""
    workflow = yaml.safe_load((RECIPES / "github.yml").read_text())
    statuses = {}
    for name, job in workflow["jobs"].items():
        assert job["defaults"]["run"]["shell"] == "bash"
        for values in matrix(job):
            variables = {key: re.sub(r"\$\{\{ matrix\.(\w+) \}\}", lambda found: str(values[found[1]]), value)
                         for key, value in job.get("env", {}).items()}
            variables |= bare(folder)
            variables["GITHUB_STEP_SUMMARY"] = str(folder / "summary.md")
            status = 0
            for step in job["steps"]:
                if "run" not in step or (status and step.get("if") != "always()"):
                    continue
                assert "${{" not in step["run"], "the shell would not see it"
                script = ["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c", step["run"]]
                status = run(script, folder, **variables) or status
            statuses[name] = statuses.get(name, 0) or status
    assert "recordings agree" in (folder / "summary.md").read_text()
    return statuses


def matrix(job):
    """The combinations of values of a job's matrix, of which ours have one variable."""
    ((name, values),) = job.get("strategy", {}).get("matrix", {"": [""]}).items()
    return [{name: value} for value in values]


def gitlab(folder):
    """The exit status of each job of the pipeline; its JUnit file is kept under a name of its own."""
    pipeline = yaml.safe_load((RECIPES / "gitlab.yml").read_text())
    statuses = {}
    (folder / "results").mkdir()
    for name, job in pipeline.items():
        if name == "default":
            continue
        total = job.get("parallel", 1)
        for index in range(1, total + 1):
            lines = pipeline["default"]["before_script"] + job["script"]
            script = ["bash", "-eo", "pipefail", "-c", "\n".join(lines)]
            status = run(script, folder, **bare(folder), CI_NODE_INDEX=str(index), CI_NODE_TOTAL=str(total))
            statuses[name] = statuses.get(name, 0) or status
            (folder / job["artifacts"]["reports"]["junit"]).rename(folder / f"results/{name}-{index}.xml")
    return statuses


def parallel(folder):
    return {"replay": run([RECIPES / "parallel.sh", "recordings", "results", "3"], folder)}


def slurm(folder):
    """One run for each task of the array that the script asks for."""
    script = RECIPES / "slurm.sh"
    first, last = map(int, re.search(r"^#SBATCH --array=(\d+)-(\d+)$", script.read_text(), re.M).groups())
    assert first == 1
    (folder / "results").mkdir()
    tasks = range(first, last + 1)
    variables = {"SLURM_ARRAY_TASK_MIN": str(first), "SLURM_ARRAY_TASK_MAX": str(last),
                 "SLURM_ARRAY_TASK_COUNT": str(len(tasks)), "SLURM_ARRAY_JOB_ID": "1"}
    return {"replay": max(run([script], folder, SLURM_ARRAY_TASK_ID=str(task), **variables) for task in tasks)}


def results(folder):
    """(name, whether it failed) of each test case of all JUnit files, by suite."""
    found = {}
    for file in sorted((folder / "results").glob("*.xml")):
        for suite in xml.etree.ElementTree.parse(file).getroot().iter("testsuite"):
            cases = [(case.get("name"), case.find("failure") is not None) for case in suite.iter("testcase")]
            assert suite.get("tests") == str(len(cases))
            assert suite.get("failures") == str(sum(failed for _, failed in cases))
            assert suite.get("errors") == "0"
            found.setdefault(suite.get("name"), []).extend(cases)
    return found


def judge(recipe, is_changed):
    """What is wrong with a recipe, as texts."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        make_folder(folder)
        if is_changed:
            change(folder)
        statuses = recipe(folder)
        found = results(folder)
        wrong = []
        if set(statuses.values()) != {1 if is_changed else 0}:
            wrong.append(f"exit status {statuses}")
        cases = found["softcnc replay"]
        names = sorted(str(path.relative_to(folder)) for path in folder.glob("recordings/**/*.rec"))
        if len(names) != RECORDINGS or sorted(name for name, _ in cases) != names:
            wrong.append(f"not every recording is replayed once: {sorted(cases)}")
        if [name for name, failed in cases if failed] != ["recordings/below/3.rec"] * is_changed:
            wrong.append(f"failures: {cases}")
        if "time" in statuses:
            failed = {name for name, has_failed in found["softcnc diff"] if has_failed}
            if failed != ({"time"} if is_changed else set()):
                wrong.append(f"the part differs in {failed}")
        return [f"{recipe.__name__}, {'a changed' if is_changed else 'no changed'} recording: {text}"
                for text in wrong]


def main():
    wrong = [text for recipe in (github, gitlab, parallel, slurm) for is_changed in (False, True)
             for text in judge(recipe, is_changed)]
    print(*wrong, sep="\n")
    return 1 if wrong else 0


if __name__ == "__main__":
    SOFTCNC = pathlib.Path(sys.argv[1]).resolve()
    ENVIRONMENT = {**os.environ, "PATH": f"{SOFTCNC.parent}{os.pathsep}{os.environ['PATH']}"}
    sys.exit(main())
