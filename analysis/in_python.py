"""From a protocol to a figure in Python:  python3 analysis/in_python.py figure.png

Changes a protocol, runs simulated participants, and asks a mixed model how ratings change with
the delay at contact. Run it line by line, or as a whole. With people, begin at impetus.read().
"""

import pathlib
import sys
import tempfile

import impetus
import matplotlib.pyplot as plt
import statsmodels.formula.api as models

here = pathlib.Path(__file__).parent.parent
causality = impetus.load_protocol(here / "protocols/causality.json")
document = causality.document
document["name"] = "delays"
document["design"]["factors"][0]["levels"] = [0, 50, 100, 200, 300]
delays = impetus.protocol(document, causality.scene)

with tempfile.TemporaryDirectory() as folder:
    study = impetus.run(delays, f"{folder}/delays.sqlite", observer="causality", participants=12)
    trials = study.trials

rated = trials[(trials.phase == "main") & trials.rating.notna()].copy()
rated["rating"] = rated.rating.astype(float)
rated["delay_ms"] = rated.factor_delay_ms.astype(float)
fit = models.mixedlm("rating ~ delay_ms", rated, groups="participant").fit()
print(fit.summary())

means = rated.groupby(["participant", "delay_ms"]).rating.mean().unstack()
plt.figure(figsize=(4, 3), layout="constrained")
plt.plot(means.columns, means.T, color="0.8", linewidth=0.8)
plt.errorbar(means.columns, means.mean(), 1.96 * means.sem(), color="black", marker="o", capsize=3)
plt.xlabel(trials.attrs["meanings"]["factor_delay_ms"].split(": ")[-1])
plt.ylabel("Rating (1 very believable, 3 not)")
plt.title(f"{delays.name}: {len(means)} simulated participants", fontsize=9)
plt.savefig(sys.argv[1] if len(sys.argv) > 1 else "delays.png", dpi=200)
