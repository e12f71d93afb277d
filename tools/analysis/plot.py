#!/usr/bin/python3
"""Draw the result files of jostle-bench and jostle-sim.

Usage: tools/analysis/plot.py KIND FILE... -o OUT [options]; the format of OUT (.svg, .png or .pdf) follows from its name.
"""

import argparse
import csv
import json
import math
import pathlib
import sys

EXIT_WITHOUT_MATPLOTLIB = 3

EPILOG = """\
kinds:
  accuracy     work-precision diagrams of `jostle-bench accuracy --csv`: CPU time against error, one
               panel per scene or family. Small markers are all rows, lines join the Pareto-optimal
               rows of each engine, and "x3" at the upper edge counts failed rows. With the file of
               --scenes-csv, axes state the measure of the error and dotted lines mark the
               tolerances. With --scene, one diagram with all modes.
  speed        time and error of `jostle-bench speed --csv`: bars per scene and engine
  growth       time and memory of `jostle-bench speed --growth N,... --csv` by number of bodies
  integrators  work-precision diagrams of `jostle-bench integrators --csv`, one panel per field
  residuals    residual per iteration of `jostle-sim SCENE --inspect BODY --csv`

A FILE is a CSV file or a JSON result of jostle-bench, whose rows have the same columns. Several
files of one kind are drawn together. docs/reference/result_files.md lists the columns and units.

examples:
  jostle-bench accuracy --scene j1,c8 --csv accuracy.csv --scenes-csv scenes.csv
  tools/analysis/plot.py accuracy accuracy.csv scenes.csv -o accuracy.svg
  tools/analysis/plot.py accuracy accuracy.csv scenes.csv --scene j1 -o j1.png
  tools/analysis/plot.py speed bench/results/speed.json --title "AMD EPYC, gcc 12.2" -o speed.svg
  jostle-sim stack --inspect --csv residuals.csv
  tools/analysis/plot.py residuals residuals.csv -o residuals.svg

exit status: 0 success, 1 a file is invalid or cannot be read or written, 2 invalid flags,
3 matplotlib is missing (scripts/setup --with-plots installs it).
"""

# Okabe and Ito: distinguishable with the common forms of color blindness. Markers and dashes differ too.
COLORS = ("#0072b2", "#e69f00", "#009e73", "#cc79a7", "#d55e00", "#56b4e9", "#000000", "#b0a000")
MARKERS = ("o", "s", "^", "D", "v", "P", "X", "*")
DASHES = ("-", "--", "-.", ":", (0, (5, 1, 1, 1, 1, 1)), (0, (3, 1)), (0, (1, 1)), (0, (7, 2)))
# Series that have the same style in every plot; others take the remaining styles in order.
KNOWN = ("jostle", "bullet", "ode", "mujoco", "box2d", "jostle, 2 threads")

LEAST_ERROR = 1e-16       # accuracy, residuals: smaller values are drawn here
LEAST_ERROR_MM = 1e-3     # speed
MOST_RESIDUAL = 1e6       # larger residuals, of diverging methods, are drawn here
PANEL_COLUMNS = 5
US_PER_SECOND = "CPU time (µs per simulated second)"


class Failure(Exception):
    """An error of the input, with the file."""


# Rows

def read_rows(path):
    """The rows of a CSV or JSON file: a list of dictionaries of column name to text; "" is missing."""
    try:
        text = pathlib.Path(path).read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise Failure(f"cannot read {path}: {getattr(error, 'strerror', None) or error}") from error
    if path.endswith(".json"):
        try:
            rows = json.loads(text)["rows"]
            rows = [{name: "" if value is None else str(value) for name, value in row.items()} for row in rows]
        except (ValueError, KeyError, TypeError, AttributeError) as error:
            raise Failure(f'{path}: not a result of jostle-bench (JSON with an array "rows"): {error}') from error
    else:
        reader = csv.DictReader(text.splitlines())
        rows = list(reader)
        for number, row in enumerate(rows, 2):
            if None in row or None in row.values():
                raise Failure(f"{path}:{number}: {len([v for v in row.values() if v is not None])} fields; "
                              f"must be {len(reader.fieldnames)}, as in line 1")
    if not rows:
        raise Failure(f"{path}: no rows")
    return rows


def require(path, rows, columns, made_by):
    missing = [column for column in columns if column not in rows[0]]
    if missing:
        raise Failure(f"{path}: no column {', '.join(missing)}; create the file with {made_by}")


def number(path, row, column):
    try:
        return float(row[column])
    except ValueError as error:
        raise Failure(f'{path}: column {column}: "{row[column]}" is not a number') from error


def in_order(values):
    return list(dict.fromkeys(values))


def rows_of(paths, columns, numbers, made_by, keep=lambda row: True):
    """The kept rows of all files, with the columns of `numbers` as numbers."""
    found = []
    for path in paths:
        rows = read_rows(path)
        require(path, rows, (*columns, *numbers), made_by)
        for row in filter(keep, rows):
            found.append({**row, **{column: number(path, row, column) for column in numbers}})
    if not found:
        raise Failure(f"{', '.join(paths)}: no successful rows")
    return found


def pareto_set(points):
    """The points (work, error) that no other point beats in both, by increasing work."""
    front = []
    for work, error in sorted(points):
        if not front or error < front[-1][1]:
            front.append((work, error))
    return front


# Drawing

def styles_of(names):
    """{name: (color, marker, dashes)}, equal in all plots for known names."""
    free = [k for k in range(len(COLORS)) if k >= len(KNOWN) or KNOWN[k] not in names]
    styles, used = {}, 0
    for name in names:
        if name in KNOWN:
            k = KNOWN.index(name)
        else:
            k, used = free[used % len(free)] if free else used % len(COLORS), used + 1
        styles[name] = {"color": COLORS[k], "marker": MARKERS[k], "linestyle": DASHES[k]}
    return styles


def log_log(axes):
    """Logarithmic axes that span whole decades, so that each has at least two labels."""
    axes.set_xscale("log")
    axes.set_yscale("log")
    for get, put, axis in ((axes.get_xlim, axes.set_xlim, axes.xaxis), (axes.get_ylim, axes.set_ylim, axes.yaxis)):
        low, high = (math.log10(limit) for limit in get())
        put(10.0 ** math.floor(low), 10.0 ** math.ceil(high))
        axis.set_minor_formatter(lambda value, position: "")
    grid(axes, "both")


def grid(axes, axis):
    axes.grid(True, axis=axis, which="major", color="#dddddd", linewidth=0.6)
    axes.set_axisbelow(True)


def subplots(plt, count, columns, width, height):
    columns = min(columns, count)
    lines = math.ceil(count / columns)
    figure, axes = plt.subplots(lines, columns, figsize=(width * columns, height * lines + 0.7), squeeze=False,
                                layout="constrained")
    panels = list(axes.flat)
    for panel in panels[count:]:
        panel.remove()
    return figure, panels[:count]


def handles_of(styles):
    from matplotlib.lines import Line2D
    return [Line2D([], [], label=name, **style) for name, style in styles.items()]


def ring_handle():
    from matplotlib.lines import Line2D
    return Line2D([], [], label="Pareto-optimal of all", color="black", marker="o", fillstyle="none", markersize=9,
                  linestyle="none")


def draw_rings(axes, points):
    axes.plot(*zip(*points), color="black", marker="o", fillstyle="none", markersize=9, linestyle="none",
              markeredgewidth=0.8, zorder=3)


# Kinds

ACCURACY = ("scene", "engine", "mode", "rate_hz")


def read_accuracy(paths):
    """The rows, and {scene: row of its scene table}."""
    results, scenes = [], {}
    for path in paths:
        rows = read_rows(path)
        if "tolerances" in rows[0]:
            require(path, rows, ("scene", "description", "error"), "jostle-bench accuracy --scenes-csv")
            scenes.update((row["scene"], row) for row in rows)
        else:
            results.append(path)
    if not results:
        raise Failure("only scene tables are given; add the rows of jostle-bench accuracy --csv")
    # Failed rows have the error "blown" in CSV and none in JSON.
    rows = rows_of(results, ACCURACY, ("error", "cpu_us_per_second"), "jostle-bench accuracy --csv",
                   lambda row: row.get("error") not in ("", "blown", None))
    for row in rows:
        row["error"] = max(row["error"], LEAST_ERROR)
    failed = [row for path in results for row in read_rows(path) if row.get("error") == "blown" or row.get("blown")]
    return rows, scenes, failed


def draw_scene(axes, rows, scene, styles, key):
    """All rows of one scene, the Pareto sets of its series, and rings about the overall Pareto set. All rows of a family."""
    fronts = len(set(row["scene"] for row in rows)) == 1
    for name, style in styles.items():
        points = [(row["cpu_us_per_second"], row["error"]) for row in rows if row[key] == name]
        if points:
            axes.plot(*zip(*points), markersize=2.2, alpha=0.45, **{**style, "linestyle": "none"})
        if points and fronts:
            axes.plot(*zip(*pareto_set(points)), markersize=4.5, linewidth=1.2, **style)
    if fronts:
        draw_rings(axes, pareto_set((row["cpu_us_per_second"], row["error"]) for row in rows))
    for tolerance in scene.get("tolerances", "").split():
        axes.axhline(float(tolerance), color="#666666", linestyle=":", linewidth=0.7)
    log_log(axes)


def draw_failed(axes, rows, styles):
    """The number of failed rows of each engine, at the upper edge."""
    for k, engine in enumerate(styles):
        count = sum(row["engine"] == engine for row in rows)
        if count:
            axes.text(0.02 + 0.16 * k, 0.97, f"x{count}", transform=axes.transAxes, color=styles[engine]["color"], fontsize=7,
                      va="top")


def accuracy(plt, options):
    rows, scenes, failed = read_accuracy(options.files)
    names = in_order(row["scene"] for row in rows)
    if options.scene and options.scene not in names:
        raise Failure(f"--scene {options.scene}: no successful rows; must be one of {', '.join(names)}")
    if options.scene or len(names) == 1:
        return accuracy_of_scene(plt, rows, options.scene or names[0], scenes)
    engines = in_order(row["engine"] for row in rows)
    styles = styles_of(engines)
    # The members of a family share a panel.
    families = {name: scenes.get(name, {}).get("family") or name for name in names}
    members = {family: [name for name in names if families[name] == family] for family in in_order(families.values())}
    scenes.update((family, scenes[group[0]]) for family, group in members.items() if group[0] in scenes)
    figure, panels = subplots(plt, len(members), PANEL_COLUMNS, 3.1, 2.7)
    for axes, (name, group) in zip(panels, members.items()):
        draw_scene(axes, [row for row in rows if row["scene"] in group], scenes.get(name, {}), styles, "engine")
        draw_failed(axes, [row for row in failed if row["scene"] in group], styles)
        axes.set_title(name, loc="left", fontweight="bold", fontsize=10)
        axes.set_ylabel(scenes.get(name, {}).get("error", "error (unit of the scene)").replace(" / ", "\n/ "), fontsize=7)
        axes.tick_params(labelsize=7)
        axes.minorticks_off()
    figure.supxlabel(US_PER_SECOND)
    title = "Work-precision diagrams (all runs; lines join the Pareto-optimal ones of each engine; x3: three failed)"
    return figure, [*handles_of(styles), ring_handle()], title


def accuracy_of_scene(plt, rows, name, scenes):
    """All modes of one scene: the color is that of the engine, the marker that of the mode."""
    rows = sorted((row for row in rows if row["scene"] == name), key=lambda row: number("", row, "rate_hz"))
    engines = styles_of(in_order(row["engine"] for row in rows))
    scene = scenes.get(name, {})
    figure, (axes,) = subplots(plt, 1, 1, 9, 6)
    draw_scene(axes, rows, scene, {}, "engine")
    handles = []
    for engine, style in engines.items():
        for k, mode in enumerate(in_order(row["mode"] for row in rows if row["engine"] == engine)):
            points = [(row["cpu_us_per_second"], row["error"]) for row in rows
                      if row["engine"] == engine and row["mode"] == mode]
            handles += axes.plot(*zip(*points), color=style["color"], marker=MARKERS[k % len(MARKERS)],
                                 linestyle=DASHES[k % len(DASHES)], markersize=5, linewidth=1.2, label=f"{engine} {mode}")
    axes.set_xlabel(US_PER_SECOND)
    axes.set_ylabel(scene.get("error", "error (unit of the scene)"))
    title = f"{name}: {scene['description']}" if "description" in scene else name
    return figure, [*handles, ring_handle()], title


def series_name(row):
    return row["engine"] if row["threads"] == "1" else f"{row['engine']}, {row['threads']} threads"


def succeeded(row):
    return not row.get("failed")


def speed(plt, options):
    rows = rows_of(options.files, ("scene", "name", "engine", "threads", "max_penetration_m", "joint_drift_m"), ("ms_mean",),
                   "jostle-bench speed --csv", succeeded)
    for row in rows:
        errors = [1e3 * float(row[column]) for column in ("max_penetration_m", "joint_drift_m") if row[column]]
        row["error_mm"] = max(*errors, LEAST_ERROR_MM) if errors else None
    scenes = in_order(f"{row['scene']} {row['name']}" for row in rows)
    styles = styles_of(in_order(map(series_name, rows)))
    figure, panels = subplots(plt, 2, 1, max(9, 0.75 * len(scenes) + 3), 3.8)
    width = 0.8 / len(styles)
    for axes, column, label in zip(panels, ("ms_mean", "error_mm"), ("mean time of a step (ms)", "error at the end (mm)")):
        for k, (name, style) in enumerate(styles.items()):
            drawn = [row for row in rows if series_name(row) == name and row[column] is not None]
            at = [scenes.index(f"{row['scene']} {row['name']}") + (k - 0.5 * (len(styles) - 1)) * width for row in drawn]
            bars = axes.bar(at, [row[column] for row in drawn], width * 0.92, color=style["color"], label=name)
            axes.bar_label(bars, fmt="%.3g", fontsize=7, rotation=90, padding=2)
        axes.set_yscale("log")
        axes.set_ylim(top=axes.get_ylim()[1] * 8)  # room for the labels
        grid(axes, "y")
        axes.set_xlim(-0.6, len(scenes) - 0.4)
        axes.set_ylabel(label)
        axes.set_xticks(range(len(scenes)), [scene.replace(" ", "\n", 1) for scene in scenes], fontsize=8)
    panels[1].set_xlabel("error: the larger of deepest overlap and joint drift; 0.001 mm or less is drawn at 0.001 mm", fontsize=9)
    return figure, panels[0].get_legend_handles_labels()[0], "Time and error of a step by scene"


def growth(plt, options):
    rows = rows_of(options.files, ("engine", "threads"), ("bodies", "ms_mean", "bytes_per_body"),
                   "jostle-bench speed --growth N,... --csv", succeeded)
    rows.sort(key=lambda row: row["bodies"])
    scenes = in_order(row.get("scene") or "pile" for row in rows)  # earlier files have no column scene
    if len(scenes) > 1:
        raise Failure(f"rows of several scenes: {', '.join(scenes)}; plot the files of one scene")
    styles = styles_of(in_order(map(series_name, rows)))
    figure, panels = subplots(plt, 2, 2, 5, 3.8)
    for axes, column, label in zip(panels, ("ms_mean", "bytes_per_body"), ("mean time of a step (ms)", "memory per body (bytes)")):
        for name, style in styles.items():
            drawn = [row for row in rows if series_name(row) == name]
            axes.plot([row["bodies"] for row in drawn], [row[column] for row in drawn], **style)
        axes.set_xlabel("bodies")
        axes.set_ylabel(label)
    log_log(panels[0])
    panels[1].set_xscale("log")
    panels[1].set_xlim(panels[0].get_xlim())
    panels[1].set_ylim(bottom=0)
    grid(panels[1], "both")
    return figure, handles_of(styles), f"{scenes[0].capitalize()}s of increasing size"


def integrators(plt, options):
    rows = rows_of(options.files, ("field", "method"), ("rate_hz", "error_m", "ns_per_step"), "jostle-bench integrators --csv")
    fields, styles = in_order(row["field"] for row in rows), styles_of(in_order(row["method"] for row in rows))
    figure, panels = subplots(plt, len(fields), 3, 4.2, 3.6)
    for axes, field in zip(panels, fields):
        for name, style in styles.items():
            drawn = sorted((row for row in rows if row["field"] == field and row["method"] == name),
                           key=lambda row: row["rate_hz"])
            axes.plot([1e-3 * row["ns_per_step"] * row["rate_hz"] for row in drawn],
                      [max(row["error_m"], LEAST_ERROR) for row in drawn], markersize=5, **style)
        log_log(axes)
        axes.set_title(field, loc="left", fontweight="bold", fontsize=10)
        axes.set_xlabel(US_PER_SECOND)
        axes.set_ylabel("RMS position error (m)")
    return figure, handles_of(styles), "Work-precision diagrams of integrators"


def residuals(plt, options):
    rows = rows_of(options.files, ("scene", "step", "group", "method", "converged"), ("iteration", "residual"),
                   "jostle-sim SCENE --inspect BODY --csv")
    groups = in_order(row["group"] for row in rows)
    if len(groups) > 1 and options.group is None:
        raise Failure(f"{len(groups)} groups; select one with --group {groups[0]} to {groups[-1]}")
    group = groups[0] if options.group is None else str(options.group)
    rows = [row for row in rows if row["group"] == group]
    if not rows:
        raise Failure(f"--group {group}: no rows; must be one of {', '.join(groups)}")
    figure, (axes,) = subplots(plt, 1, 1, 8, 5)
    styles = styles_of(in_order(row["method"] for row in rows))
    for name, style in styles.items():
        drawn = [row for row in rows if row["method"] == name]
        label = name if drawn[0]["converged"] == "1" else f"{name} (not converged)"
        axes.plot([row["iteration"] for row in drawn],
                  [min(max(row["residual"], LEAST_ERROR), MOST_RESIDUAL) for row in drawn],
                  label=label, markevery=max(1, len(drawn) // 12), **style)
    log_log(axes)
    axes.set_xlabel("iteration")
    axes.set_ylabel("residual relative to b")
    return figure, axes.get_legend_handles_labels()[0], f"{rows[0]['scene']} after step {rows[0]['step']}, group {group}"


KINDS = {"accuracy": accuracy, "speed": speed, "growth": growth, "integrators": integrators, "residuals": residuals}


# Program

def parser():
    made = argparse.ArgumentParser(prog="plot.py", description="Draw the result files of jostle-bench and jostle-sim.",
                                   epilog=EPILOG, formatter_class=argparse.RawDescriptionHelpFormatter)
    made.add_argument("kind", metavar="KIND", choices=KINDS, help="image to draw: " + ", ".join(KINDS) + "; see below")
    made.add_argument("files", metavar="FILE", nargs="+", help="CSV or JSON files of this kind")
    made.add_argument("-o", "--out", metavar="OUT", required=True, help="write the image to OUT (.svg, .png or .pdf)")
    made.add_argument("--title", metavar="TEXT", help="replace the title, for example to name the machine")
    made.add_argument("--scene", metavar="NAME", help="accuracy: draw all modes of this scene")
    made.add_argument("--group", metavar="N", type=int, help="residuals: draw this group [default: the only one]")
    return made


def main():
    options = parser().parse_args()
    if pathlib.Path(options.out).suffix not in (".svg", ".png", ".pdf"):
        print(f"plot.py: --out {options.out}: the name must end in .svg, .png or .pdf", file=sys.stderr)
        return 2
    try:
        import matplotlib
    except ImportError:
        print("plot.py: the Python module matplotlib is missing; install it with scripts/setup --with-plots", file=sys.stderr)
        return EXIT_WITHOUT_MATPLOTLIB
    matplotlib.use("Agg")
    # Text stays text; equal input gives equal bytes.
    matplotlib.rcParams.update({"svg.fonttype": "none", "svg.hashsalt": "jostle", "font.family": "sans-serif", "font.size": 9})
    import matplotlib.pyplot as plt
    try:
        figure, handles, title = KINDS[options.kind](plt, options)
        finish(figure, handles, options.title or title)
        figure.savefig(options.out, dpi=110, bbox_inches="tight",
                       metadata={"Date": None} if options.out.endswith(".svg") else None)
    except Failure as failure:
        print(f"plot.py: {failure}", file=sys.stderr)
        return 1
    except OSError as error:
        print(f"plot.py: cannot write {options.out}: {error.strerror}", file=sys.stderr)
        return 1
    return 0


def finish(figure, handles, title):
    """Puts the title and the legend above the panels, outside the area that the layout fills."""
    width = figure.get_figwidth()
    longest = max(len(handle.get_label()) for handle in handles)
    columns = max(1, min(len(handles), int(width / (0.085 * longest + 0.75))))
    figure.legend(handles=handles, loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=columns, frameon=False)
    lines = math.ceil(len(handles) / columns)
    figure.text(0.5, 1 + (0.2 * lines + 0.25) / figure.get_figheight(), title, ha="center", fontsize=12, fontweight="bold")


if __name__ == "__main__":
    sys.exit(main())
