"""Writes a short version of a protocol: the levels of its first factor once, those of others at their first.

Usage: shorten.py FROM TO
"""
import json
import sys

source, target = sys.argv[1:]
with open(source) as file:
    protocol = json.load(file)
design, session = protocol["design"], protocol["session"]
for factor in design["factors"][1:]:
    factor["levels"] = factor["levels"][:1]
design["repetitions"] = 1
design["practice"] = [{factor["name"]: factor["levels"][0] for factor in design["factors"]}]
design.pop("longest_runs", None)
design.pop("practice_until", None)
protocol.pop("exclude_when", None)
session.pop("demonstrations", None)
with open(target, "w") as file:
    json.dump(protocol, file)
