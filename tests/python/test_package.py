# SPDX-License-Identifier: MIT
"""The package as its reader meets it: help, types, the page in analysis/."""

import os
import pathlib
import pydoc
import re
import subprocess
import sys
import tempfile
import unittest

import impetus

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


class Package(unittest.TestCase):
    def test_everything_public_says_what_it_is(self):
        for name in impetus.__all__:
            self.assertTrue(pydoc.getdoc(getattr(impetus, name)), name)
        for kind in (impetus.World, impetus.Protocol, impetus.Study, impetus.Replay, impetus.Step,
                     impetus.Collision, impetus.Contact, impetus.Tree, impetus.Pair):
            for name, member in vars(kind).items():
                if not name.startswith("_"):
                    words = member.__doc__ or ""
                    if "(self" in words:  # begins with its signature
                        words = words.partition("\n\n")[2]
                    self.assertTrue(words.strip(), f"{kind.__name__}.{name}")
        page = pydoc.render_doc(impetus, renderer=pydoc.plaintext)
        self.assertIn('impetus.read("study.sqlite")', page)

    def test_the_stub_names_what_the_module_has(self):
        from impetus import _impetus

        stub = (ROOT / "experiments/python/impetus/_impetus.pyi").read_text("utf-8")
        for kind in re.findall(r"^class (\w+)", stub, re.M):
            body = stub.split(f"class {kind}", 1)[1].split("\nclass ", 1)[0].split("\ndef ", 1)[0]
            own = {name for name in vars(getattr(_impetus, kind)) if not name.startswith("_")}
            told = {name for name in re.findall(r"def (\w+)", body) if not name.startswith("_")}
            if kind not in ("InputError", "StoreError"):
                self.assertEqual(own, told, kind)
        functions = set(re.findall(r"^def (\w+)", stub, re.M))
        self.assertEqual(functions, {name for name, value in vars(_impetus).items()
                                     if callable(value) and not isinstance(value, type)})

    def test_types_are_sound(self):
        with tempfile.TemporaryDirectory() as cache:
            done = subprocess.run(
                [sys.executable, "-m", "mypy", "--strict", "--ignore-missing-imports", "--cache-dir",
                 cache, "-p", "impetus"],
                cwd=ROOT / "experiments/python", capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_the_build_is_the_programs(self):
        said = subprocess.run([impetus.program(), "--version"], capture_output=True, text=True)
        self.assertEqual(impetus.version(), said.stdout.strip())

    def test_the_page_goes_from_a_protocol_to_a_figure_in_forty_lines(self):
        page = ROOT / "analysis/in_python.py"
        lines = [line for line in page.read_text("utf-8").splitlines() if line.strip()]
        self.assertLessEqual(len(lines), 40)
        with tempfile.TemporaryDirectory() as folder:
            figure = pathlib.Path(folder) / "figure.png"
            done = subprocess.run([sys.executable, page, figure], capture_output=True, text=True,
                                  env={**os.environ, "MPLBACKEND": "Agg", "MPLCONFIGDIR": folder})
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertGreater(figure.stat().st_size, 10_000)
        self.assertRegex(done.stdout, r"delay_ms +0\.00\d")

    def test_a_mixed_model_agrees_with_that_of_r(self):
        import statsmodels.formula.api as models

        with tempfile.TemporaryDirectory() as folder:
            study = impetus.run("protocols/causality.json", pathlib.Path(folder) / "s.sqlite",
                                observer="causality", participants=8, seed=2)
            rated = study.trials[study.trials.phase == "main"].copy()
            rated["rating"] = rated.rating.astype(float)
            rated["delay"] = rated.factor_delay_ms.astype(float) / 100.0  # alike in size
            file = pathlib.Path(folder) / "rated.csv"
            rated[["participant", "rating", "delay"]].to_csv(file, index=False)
            said = subprocess.run(
                ["Rscript", "-e", "f <- lme4::lmer(rating ~ delay + (1 | participant), "
                 f"read.csv('{file}')); cat(lme4::fixef(f), summary(f)$coefficients[, 2], "
                 "as.data.frame(lme4::VarCorr(f))$vcov, sep = '\\n')"],
                check=True, capture_output=True, text=True).stdout.split()
            fit = models.mixedlm("rating ~ delay", rated, groups="participant").fit()
        own = [*fit.fe_params, *fit.bse_fe, float(fit.cov_re.iloc[0, 0]), fit.scale]
        self.assertEqual(len(own), len(said))
        for mine, theirs in zip(own, map(float, said)):
            self.assertAlmostEqual(mine, theirs, delta=1e-4 * max(1.0, abs(theirs)))


if __name__ == "__main__":
    unittest.main()
