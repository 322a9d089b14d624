#!/usr/bin/env python3
"""check_describe.py DESCRIBE.PY INCLUDE: describe.py stops at changes of a header that it cannot understand, and sees
all others."""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

# header, what stands there, what is put in its place: not understood
BROKEN = [
    ("chain.h", "CD_API cd_status cd_chain_reset(cd_chain* chain);", "CD_API cd_status cd_chain_reset(cd_chain*);"),
    ("chain.h", "CD_API cd_status cd_chain_reset(cd_chain* chain);", "cd_status cd_chain_reset(cd_chain* chain);"),
    ("chain.h", "CD_API cd_status cd_chain_reset(", "CD_API cd_status cd_chains_reset("),
    ("chain.h", "(cd_chain* chain, double mass)", "(cd_chain* chain, double mass, ...)"),
    ("chain.h", "(cd_chain* chain, double mass)", "(cd_chain* chain, long mass)"),
    ("chain.h", "(cd_chain* chain, double mass)", "(cd_chain* chain, const double* masses)"),
    ("chain.h", "enum { CD_END_FIRST = 0, CD_END_LAST = 1 };", "enum { CD_END_FIRST, CD_END_LAST };"),
    ("chain.h", "enum { CD_END_FIRST = 0, CD_END_LAST = 1 };", "enum { CD_END_FIRST = 0, CD_END_LAST = 0 };"),
    ("chain.h", "typedef struct cd_chain cd_chain;", "typedef struct cd_chain cd_chain;\nstruct cd_extra { int a; };"),
    ("chain.h", " *  CD_BEND       (strand), node ", " *  CD_BENDS      (strand), node "),
    ("chain.h", "/* ---- measuring ---", "/* ---- Measuring, 2 ---"),
    ("chain.h", "size_t strand, const double* rotation", "size_t strand, const double* turn"),
    ("membrane.h", "cd_membrane_sample(", "cd_membrane_probe("),
    ("membrane.h", "CD_STIFFNESS_U       spring    N/m ", "CD_STIFFNESS_U       spring   N/m  "),
    ("membrane.h", "CD_STRAIN_U, _V ", "CD_STRAIN_U, _W "),
    ("membrane.h", "CD_STRAIN_U, _V ", "CD_STRAIN_U     "),
    ("membrane.h", "const double* point, const double* normal", "const double* place, const double* normal"),
    ("chain.h", "Drag [1/s], >= 0:", "Drag [1/s]:"),
    ("chain.h", "Mass [kg], > 0.", "Mass [pound], > 0."),
    ("membrane.h", "most_iterations, >= 1,", "most_iterations"),
    ("membrane.h", "(cd_membrane* membrane, size_t u, size_t v);", "(cd_membrane* membrane, size_t u, size_t w);"),
    ("water.h", "in [0, 1e30], over directions", "from 0 on, over directions"),
    ("base.h", "#define CD_VERSION_PATCH 0", "#define CD_VERSION_PATCH 0\n#define CD_LIMIT 7"),
    ("base.h", "    void* user;\n    void* (*allocate)", "    void* user[2];\n    void* (*allocate)"),
    ("water.h", "CD_API cd_status cd_water_reset(", "#if 0\n#endif\nCD_API cd_status cd_water_reset("),
]
# ...: described otherwise
CHANGED = [
    ("chain.h", "cd_chain_set_mass(cd_chain* chain, double mass)", "cd_chain_set_mass(cd_chain* chain, float mass)"),
    ("chain.h", "cd_chain_get_mass(const cd_chain* chain", "cd_chain_get_mass(cd_chain* chain"),
    ("chain.h", "Mass [kg], > 0.", "Mass [N], > 0."),
    ("base.h", "CD_METHOD_STIFF_SECOND = 3", "CD_METHOD_STIFF_SECOND = 4"),
    ("base.h", "size_t size, size_t alignment);\n    void (*release)", "size_t size);\n    void (*release)"),
    ("water.h", "CD_DEPTH         cell          m ", "CD_DEPTH         cell          cm"),
    ("water.h", "cd_water_get_wet_area", "cd_water_get_wetted"),
]


def described(script, include, header=None, old="", new=""):
    """The description of changed headers, or None if it is refused."""
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / "contdyn"
        copy.mkdir()
        for path in (include / "contdyn").glob("*.h"):
            text = path.read_text(encoding="utf-8")
            if path.name == header:
                assert old in text, f"{header} has no '{old}'"
                text = text.replace(old, new, 1)
            (copy / path.name).write_text(text, encoding="utf-8")
        done = subprocess.run([sys.executable, script, "--include", folder, "--output", "-"], text=True,
                              capture_output=True, check=False)
    if done.returncode:
        assert "not understood" in done.stderr, done.stderr
        return None
    return json.loads(done.stdout)


def main():
    script, include = sys.argv[1], Path(sys.argv[2])
    whole = described(script, include)
    assert whole is not None
    for case in BROKEN:
        assert described(script, include, *case) is None, f"understood: {case}"
    for case in CHANGED:
        changed = described(script, include, *case)
        assert changed is not None and changed != whole, f"not seen: {case}"


if __name__ == "__main__":
    main()
