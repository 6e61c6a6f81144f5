"""kernel_test.py PROGRAM: runs every kernel's benchmark shortly; each must measure a speed."""

import json
import math
import subprocess
import sys

done = subprocess.run([sys.argv[1], "--benchmark_min_time=0.001", "--benchmark_format=json"],
                      stdout=subprocess.PIPE, text=True, check=True)
kernels = json.loads(done.stdout)["benchmarks"]
assert len(kernels) == 9, [kernel["name"] for kernel in kernels]
for kernel in kernels:
    assert not kernel.get("error_occurred"), kernel
    for value in (kernel["real_time"], kernel["cpu_time"], kernel["items_per_second"]):
        assert math.isfinite(value) and value > 0, kernel
print(f"{len(kernels)} kernels measured")
