#!/usr/bin/python3
"""Runs tools/analysis/plot.py on small files. Exit status 77 (skipped) if matplotlib is missing."""

import contextlib
import importlib.util
import io
import pathlib
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

ROOT = pathlib.Path(__file__).resolve().parents[3]
PLOT = ROOT / "tools/analysis/plot.py"

ACCURACY = """scene,engine,mode,rate_hz,error,second_error,cpu_us_per_second
j1,jostle,sub8,30,0.02,0,50
j1,jostle,sub8,60,0.005,0,100
j1,bullet,si10,60,0.004,0,90
j1,ode,world,60,blown,,
f1,jostle,sub8,60,0,0,10
"""
SCENES = """scene,description,error,second_error,tolerances
j1,a pendulum,"RMS position error, m","widest joint gap, m",0.1 0.01
"""
SPEED = """scene,name,engine,threads,steps,failed,ms_mean,max_penetration_m,joint_drift_m
a,pyramid,jostle,1,600,,1.6,0.0007,
a,pyramid,jostle,2,600,,0.9,0.0007,0.001
a,pyramid,bullet,1,600,,3.1,,
a,pyramid,ode,1,600,ended by signal 11,,,
"""
GROWTH = """engine,threads,bodies,failed,ms_mean,clock,bytes_per_body
jostle,1,500,,1,cpu,2000
jostle,1,5000,,12,cpu,1800
bullet,1,500,,3,cpu,4000
"""
INTEGRATORS = """field,method,rate_hz,error_m,order,energy_drift,ns_per_step
kepler,rk4,240,1e-5,,1e-6,80
kepler,rk4,480,6e-7,4,1e-7,80
kepler,verlet,240,1e-3,,1e-6,20
"""
RESIDUALS = """scene,step,group,method,converged,iteration,residual
stack,120,0,Gauss-Seidel,1,1,0.5
stack,120,0,Gauss-Seidel,1,2,0
stack,120,0,conjugate gradients,0,1,1e30
"""


class Plot(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def file(self, name, text):
        path = pathlib.Path(self.folder.name) / name
        path.write_text(text, encoding="utf-8")
        return str(path)

    def run_plot(self, *arguments):
        """Like run_program, in this process: loading matplotlib takes 1 s."""
        import matplotlib.pyplot
        spec = importlib.util.spec_from_file_location("plot", PLOT)
        plot = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(plot)
        out, err = io.StringIO(), io.StringIO()
        with (unittest.mock.patch.object(sys, "argv", [str(PLOT), *arguments]), contextlib.redirect_stdout(out),
              contextlib.redirect_stderr(err), matplotlib.rc_context()):
            try:
                status = plot.main()
            except SystemExit as end:  # argparse
                status = end.code
        matplotlib.pyplot.close("all")
        return subprocess.CompletedProcess(arguments, status, out.getvalue(), err.getvalue())

    def run_program(self, *arguments):
        return subprocess.run([PLOT, *arguments], capture_output=True, text=True)

    def draw(self, kind, *files, options=()):
        out = pathlib.Path(self.folder.name) / "out.svg"
        run = self.run_plot(kind, *files, *options, "-o", str(out))
        self.assertEqual(run.returncode, 0, run.stderr)
        return out.read_text(encoding="utf-8")

    def expect(self, image, words):
        for word in words:
            self.assertIn(word, image)

    def expect_failure(self, message, kind, text, *options, name="in.csv"):
        run = self.run_plot(kind, self.file(name, text), "-o", "/tmp/unused.svg", *options)
        self.assertEqual(run.returncode, 1, run.stderr)
        self.assertIn(message, run.stderr)
        self.assertNotIn("Traceback", run.stderr)

    def test_draws_a_panel_per_scene_with_its_error_measure(self):
        image = self.draw("accuracy", self.file("a.csv", ACCURACY), self.file("s.csv", SCENES))
        self.expect(image, [">j1<", ">f1<", "RMS position error, m", "µs per simulated second", ">jostle<", "Pareto-optimal"])
        self.assertNotIn(">ode<", image)  # its only row failed

    def test_draws_all_rows_and_counts_failed_ones(self):
        more = ACCURACY + "j1,bullet,si4,60,0.0045,0,95\nj1,jostle,sub1,60,blown,,\n"
        few, all_rows = (self.draw("accuracy", self.file("a.csv", text)) for text in (ACCURACY, more))
        self.assertEqual(all_rows.count("<use "), few.count("<use ") + 1)  # beaten by si10
        self.assertIn(">x1<", all_rows)
        self.assertNotIn(">x1<", few)

    def test_members_of_a_family_share_a_panel(self):
        rows = "".join(f"slide-{k},jostle,sub8,{hz},0.0{k},0,{hz}\n" for k in (1, 2) for hz in (30, 60))
        scenes = ("scene,family,description,error,second_error,tolerances\n"
                  "slide-1,slide,a box,path,none,0.1\nslide-2,slide,a hull,path,none,0.1\nj1,,a pendulum,position,none,0.1\n")
        image = self.draw("accuracy", self.file("a.csv", ACCURACY + rows), self.file("s.csv", scenes))
        self.expect(image, [">slide<", ">j1<", ">position<"])
        self.assertNotIn(">slide-1<", image)

    def test_draws_all_modes_of_one_scene(self):
        image = self.draw("accuracy", self.file("a.csv", ACCURACY), self.file("s.csv", SCENES), options=("--scene", "j1"))
        self.expect(image, ["j1: a pendulum", "jostle sub8", "bullet si10"])
        self.assertNotIn(">f1<", image)

    def test_draws_speed_with_units(self):
        image = self.draw("speed", self.file("s.csv", SPEED), options=("--title", "R & D"))
        self.expect(image, ["pyramid", "jostle, 2 threads", "(ms)", "(mm)", "R &amp; D", ">3.1<"])
        self.assertNotIn(">ode<", image)

    def test_draws_growth_integrators_and_residuals(self):
        self.expect(self.draw("growth", self.file("g.csv", GROWTH)), ["Piles", "bodies", "(bytes)", "jostle", "bullet"])
        chains = GROWTH.replace("engine,", "scene,engine,").replace("jostle,", "chain,jostle,").replace("bullet,", "chain,bullet,")
        self.expect(self.draw("growth", self.file("c.csv", chains)), ["Chains", "jostle", "bullet"])
        mixed = chains.replace("chain,bullet", "pile,bullet")
        self.expect_failure("rows of several scenes: chain, pile", "growth", mixed)
        self.expect(self.draw("integrators", self.file("i.csv", INTEGRATORS)), ["kepler", "verlet", "RMS position error (m)"])
        self.expect(self.draw("residuals", self.file("r.csv", RESIDUALS)),
                    ["stack after step 120", "conjugate gradients (not converged)", "iteration", "residual relative to b"])

    def test_reads_json_results_and_repeats_its_bytes(self):
        result = self.file("g.json", '{"benchmark":"speed growth","rows":[{"engine":"jostle","threads":1,"bodies":500,'
                                     '"failed":null,"ms_mean":1.2,"clock":"cpu","bytes_per_body":10470.0}]}')
        self.assertEqual(self.draw("growth", result), self.draw("growth", result))

    def test_draws_committed_results(self):
        for kind in ("speed", "growth"):
            self.draw(kind, str(ROOT / f"bench/results/{kind}.json"))

    def test_errors_name_the_file_and_the_column(self):
        self.expect_failure("in.csv: no column threads, ms_mean, bytes_per_body; create the file with jostle-bench speed", "growth", "engine,bodies\njostle,5\n")
        self.expect_failure("in.csv: no rows", "growth", "engine,bodies\n")
        self.expect_failure("in.csv:3: 2 fields; must be 7, as in line 1", "residuals",
                            "\n".join(RESIDUALS.splitlines()[:2]) + "\nstack,1\n")
        self.expect_failure('column residual: "much" is not a number', "residuals", RESIDUALS.replace("0.5", "much"))
        self.expect_failure("no successful rows", "growth", "engine,threads,bodies,failed,ms_mean,bytes_per_body\nj,1,5,lost,,\n")
        self.expect_failure("--scene j9: no successful rows; must be one of j1, f1", "accuracy", ACCURACY, "--scene", "j9")
        self.expect_failure("only scene tables", "accuracy", SCENES)
        self.expect_failure("2 groups; select one with --group", "residuals", RESIDUALS + "stack,120,1,Gauss-Seidel,1,1,1\n")
        self.expect_failure("not a result of jostle-bench", "speed", "[]", name="in.json")
        run = self.run_plot("growth", self.file("g.csv", GROWTH), "-o", "/nowhere/out.svg")
        self.assertEqual((run.returncode, run.stderr), (1, "plot.py: cannot write /nowhere/out.svg: No such file or directory\n"))
        self.assertEqual(self.run_plot("drawing", "in.csv", "-o", "out.svg").returncode, 2)

    def test_the_program_draws_and_reports_errors(self):
        out = pathlib.Path(self.folder.name) / "program.svg"
        run = self.run_program("growth", self.file("g.csv", GROWTH), "-o", str(out))
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertEqual(out.read_text(encoding="utf-8"), self.draw("growth", self.file("g.csv", GROWTH)))
        run = self.run_program("growth", "/nowhere/in.csv", "-o", "/tmp/unused.svg")
        self.assertEqual((run.returncode, run.stderr), (1, "plot.py: cannot read /nowhere/in.csv: No such file or directory\n"))
        self.assertEqual(self.run_program("growth", "in.csv", "-o", "out.gif").returncode, 2)

    def test_help_lists_the_kinds(self):
        text = self.run_program("--help").stdout
        for kind in ("accuracy", "speed", "growth", "integrators", "residuals"):
            self.assertIn(f"\n  {kind} ", text)
        self.assertLessEqual(max(map(len, text.splitlines())), 100)


if __name__ == "__main__":
    if importlib.util.find_spec("matplotlib") is None:
        print("skipped: matplotlib is missing; install it with scripts/setup --with-plots")
        sys.exit(77)
    unittest.main()
