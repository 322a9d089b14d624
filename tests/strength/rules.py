"""The rules that take_out.py takes out."""

from rules_cloth import CLOTH_RULES

SLEEP, SURVEY = "../model/water_sleep.cpp", "../model/water_survey.cpp"
SLEEPS = ["physics_water_sleep"]
BODIES = ["physics_sleep", "physics_sleep_colliders"]
TOUCHES, OVERLAPS = ["physics_rope_contact"], ["physics_rope_overlaps"]
HULL, HULL_PLATES = "../model/water_hull.hh", "../model/water_hull_plates.hh"
HULL_STEP = "../model/water_hull_step.cpp"

# Name: file, what is there, what takes its place, tests to run (the first one that fails ends a rule).
RULES = CLOTH_RULES | {
    "a dry bed pushes nothing": (
        "water/line.hh", "return select(select(rise, c.r.depth, c.l.depth), rise, L{});", "return rise;",
        ["physics_water_lake"]),
    "a face shallower than the mean beside a shallow giver": (
        "water/face.hh", "const L shallower = smaller(mean, most),", "const L shallower = mean,",
        ["physics_water_dams", "physics_water_thacker", "stability_water_energy"]),
    "a face deeper than the mean where water falls": (
        "water/face.hh", "deeper = larger(mean, smaller(fall, over));", "deeper = mean;",
        ["physics_water_dams", "physics_water_sides", "physics_water_thacker", "stability_water_energy"]),
    "water climbs as far as its speed lifts it": (
        "water/face.hh", "over + kClimbedHeads * head", "L::splat(1e300)", ["physics_water_lake"]),
    "what runs dry keeps more than rounding": (
        "water/face.hh", "kGives = 1 - 0x1p-40;", "kGives = 1 - 0x1p-53;", ["physics_water_symmetry"]),
    "a stream carries changes of depth along": ("water/surface.hh", "k = theta * cells,", "k = 0.0 * cells,",
        ["stability_water_currents"]),
    "the stream's acceleration counts in fluxes": (
        "water/surface.hh", "through = through + theta * stream;", "through = through + 0.0 * stream;",
        ["physics_water_sides"]),
    "no cell gives more than it has and gets": (
        "water/line.hh", "if (any_positive(-least)) limit(-least);", "", ["stability_water_volume"]),
    "no more comes in at a side than to an empty cell": (
        "water/limiter.hh", "    if (!ring) { //", "    if (false) { //", ["stability_water_extremes"]),
    "what fills a cell at a side ends at the level outside": (
        "water/side.hh", "d_out > d ? most / (d_out - d) : 0", "0", ["physics_water_sides", "stability_water_extremes"]),
    "as does what comes in at an open side": (
        "water/side.hh", "secant > tangent ? secant : tangent", "tangent", ["stability_water_extremes"]),
    "of linear momentum too": ("water/side.hh", "c > tangent ? c : tangent", "tangent", ["stability_water_extremes"]),
    "and at a level's critical depth": (
        "water/side.hh", "if (bounded < 0 && d < d_out && (is_most || !(d > 0))) return fills(d, d_out, -bounded, says.depth);", "",
        ["stability_water_extremes"]),
    "velocities follow what the limiter lets through": (
        "water/velocity.hh", "if (any_limited)", "if (false)", ["stability_water_energy"]),
    "and what does not go through gains nothing": (
        "water/momentum.hh", "        if (any_limited) {", "        if (false) {", ["stability_water_energy"]),
    "the energy bound of long steps": ("water/line.hh", "if (any_long) balance();", "", ["stability_water_energy"]),
    "a long step is rough from a change of 5% on": (
        "water/velocity.hh", "constexpr double kRoughChange = 0.05;", "constexpr double kRoughChange = 1;",
        ["stability_water_energy"]),
    "and at shores": ("water/surface.hh", "select(shallower, uneven, mean)", "uneven", ["stability_water_energy"]),
    "advected only where a depth changes by half": (
        "water/velocity.hh", "constexpr double kRoughFace = 0.5;", "constexpr double kRoughFace = 0.05;", ["physics_water_dams"]),
    "what pushes from outside does work": ("water/velocity.hh", "return acceleration ? lift -", "return false ? lift -",
        ["physics_water_forces"]),
    "parts of half a cell": (
        "water/sweep.cpp", "constexpr double kPartRun = 0.5;", "constexpr double kPartRun = 1e9;", ["stability_water_currents"]),
    "each half of a longer one": (
        "water/sweep.cpp", "speeds.see(line.velocity[i])", "speeds.see(0.0 * line.velocity[i])", ["stability_water_energy"]),
    "which count what comes in": (
        "water/sweep.cpp", "-speeds.least), coming_in(line))", "-speeds.least), 0.0 * coming_in(line))",
        ["stability_water_extremes"]),
    "a dry cell gives no stream": (
        "water/momentum.hh", "select(select(u, l, r), (", "select(L::splat(1), (", ["physics_water_forces"]),
    "what comes in a long step is pushed, too": (
        "water/momentum.hh", "theta * (v1 - v0) * (", "0.0 * (v1 - v0) * (", ["physics_water_momentum"]),
    "no line gains energy in a long step": (
        "water/momentum.hh", "if (any_long) keep_energy();", "", ["stability_water_waves"]),
    "whose parts are long": (
        "water/sweep.cpp", "sweep.advected() ? L::splat(sweep.courant) : line.courant;", "line.courant;", ["stability_water_energy"]),
    "faces that follow the water do so at once": (
        "water/velocity.hh", "const bool dry = !all_positive(least);", "const bool dry = false;", ["stability_water_hulls"]),
    "lines without water are not solved": (
        "water/sweep.cpp", "if (is_dry(line, depths)) {", "if (false) {", ["api_water_cost"]),
    "impulses weigh all of the water that moves": (
        "../model/water_act.cpp", "moving_depth(w, a, i, j)", "face_depth(w, a, i, j)", ["api_water_acting"]),
    "what is to be dry counts as dry": (
        "water/velocity.hh", "after.put(i, settled(after[i], kDry)); //", "//", ["stability_water_hulls"]),
    "closed faces follow nothing": (
        "water/velocity.hh", "out.put(i, open(i) * follows);", "out.put(i, follows);", ["stability_water_hulls"]),
    "water lifts no more than it has energy for": (
        "water/velocity.hh", "within(part, 0, 1)", "within(part, 1, 1)", ["stability_water_energy"]),
    "nor takes it from the momentum of a ring": (
        "water/velocity.hh", "ring ? select(gap, none, momentum / mass) : none;", "none;", ["physics_water_momentum"]),
    "friction goes by the speed, not by its part along an axis": (
        "water/face.hh", "if (!any_positive(across)) break;", "break;", ["physics_water_forces"]),
    "and none where there is no water, however fast": (
        "water/face.hh", "return select(k, k * s, L{});", "return k * s;", ["determinism_water_kernels"]),
    "in directions that are found three times": (
        "water/face.hh", "constexpr int kDirections = 3;", "constexpr int kDirections = 2;", ["physics_water_forces"]),
    "and by what the stream brings": (
        "water/surface.hh", "size_of((kept - rise) + gains)", "size_of(kept - rise)", ["physics_water_forces"]),
    "of which it leaves as much as of a push": (
        "water/momentum.hh", "u = w + line.push[i] * (u - w);", "", ["physics_water_forces"]),
    "what it stops in a step moves as at the step's end": (
        "water/line.hh", "return sweep.implicit ? larger(theta, L::splat(1) - part) : theta;", "return theta;", ["physics_water_forces"]),
    "what comes in at an end brings energy": (
        "water/velocity.hh", "if (!ring) most =", "if (false) most =", ["physics_water_sides", "stability_water_extremes"]),
    "what comes in in a given depth has its speed from that": (
        "water/velocity.hh", "const bool is_given = sweep.end[e].depth > 0;", "const bool is_given = false;",
        ["physics_water_gates"]),
    "slopes of velocities within cells": (
        "water/momentum.hh", "    return part * half_slope(", "    return 0.0 * part * half_slope(",
        ["physics_water_sides"]),
    "no slope reaches behind a wall": (
        "water/momentum.hh", "l = select(open(cell), ", "l = select(L::splat(1), ", ["physics_water_symmetry"]),
    "of velocities across lines neither": (
        "water/across.cpp", "return beside ?", "return false ?", ["physics_water_symmetry"]),
    "slopes only where depths are even": (
        "water/momentum.hh", "return positive(smaller(least,", "return least; return positive(smaller(least,",
        ["stability_water_currents", "stability_water_energy", "physics_water_thacker"]),
    "slopes add no more than goes through": (
        "water/momentum.hh", "* even[cell], size_of(through));", "* even[cell], L::splat(1e300));",
        ["physics_water_symmetry"]),
    "half of the momentum goes with old velocities": (
        "water/momentum.hh", "out.early = 0.5 *", "out.early = 0.0 *", ["physics_water_dams", "physics_water_thacker"]),
    "dry faces take the speed of what comes": (
        "water/velocity.hh", "sweep.advected() ? led : none", "none", ["physics_water_thacker", "physics_water_dams"]),
    "but not at a cliff": (
        "water/velocity.hh", "within(falls / (kBeach * step), 0, 1)", "L::splat(1)", ["stability_water_energy"]),
    "which energies count": (
        "../model/water_measure.cpp", "return part > 0 ? (part < 1 ? part : 1) * number(w.velocity[a], other) : 0;", "return 0 * part;",
        ["stability_water_energy"]),
    "slopes across": (
        "water/across.cpp", "const L part = smaller(q, positive(given - q))", "const L part = 0.0 * q",
        ["physics_water_thacker", "physics_water_momentum"]),
    "between dry lines nothing moves": (
        "water/across.cpp", "select(water[i], select(passes, u, velocity[i]), L{})", "select(passes, u, velocity[i])", ["api_water_diverge"]),
    "what crosses a level side follows as waves cross half a cell": (
        "water/side.hh", "return part < 1 ? part : 1;", "return 1 + 0 * part;", ["physics_water_sides"]),
    "and in long steps at once, not beyond": (
        "water/side.hh", "return part < 1 ? part : 1;", "return part;", ["stability_water_waves"]),
    "a level side passes on the discharge that comes": (
        "water/side.hh", "? (cell.discharge - fill) / depth", "? u - fill / depth", ["stability_water_waves"]),
    "what comes in from a level has its speed from it": (
        "water/side.hh", "in = advected &&", "in = false && advected &&", ["physics_water_momentum"]),
    "and what fills a cell with the level stays there": (
        "water/side.hh", "(cell.discharge - fill)", "(cell.discharge - 0 * fill)", ["physics_water_sides"]),
    "a side's depth is that of half a cell before": (
        "water/surface.hh", "- L::load(half_cell))", "- 0.0 * L::load(half_cell))", ["physics_water_sides"]),
    "and a cell between two sides has one half on each": (
        "water/surface.hh", "const bool is_shared = n == 1 &&", "const bool is_shared = false && n == 1 &&",
        ["physics_water_symmetry"]),
    "which a wall behind it takes from none": (
        "water/surface.hh", "n == 1 && sweep.end[1 - e].kind != End::kWall;", "n == 1;", ["physics_water_symmetry"]),
    "what leaves runs no faster than it came": (
        "water/velocity.hh", "larger(-most, smaller(most, u))", "u", ["physics_water_symmetry"]),
    "what rounding takes is handed on": (
        "water/sweep.cpp", "            chain[0].owed = chain[0].owed + round_back(depth, end, rest, deepest);\n", "",
        ["physics_water_lake"]),
    "where its water ends": ("water/sweep.cpp", "&& !wide) hand_back", "&& false) hand_back", ["physics_water_lake"]),
    "whole steps count before a part of one": ("../model/water_step.cpp", "((double(w.clock.counted) + done) + part)",
        "(double(w.clock.counted) + (done + part))", ["determinism_water_parallel"]),
    "a ring of one line carries velocities across it": (
        "../model/water_step.cpp", "(w.cells[other(a)] > 1 || periodic(w, other(a)))", "w.cells[other(a)] > 1",
        ["physics_water_momentum"]),
    "waves wake what a step carries them into": (SLEEP, "left > weakest && ", "left > 1e300 * weakest && ", SLEEPS),
    "what acts may raise waves at once": ("../model/water_sleep.hh", "kStrong = 1024;", "kStrong = 1;", SLEEPS),
    "a face belongs to the part behind it": (
        SURVEY, "return marked(x, y) || marked(x_before, y) || marked(x, y_before);",
        "return marked(x, y) || (x_before > x && y_before > y);", SLEEPS),
    "what falls asleep is still": (SLEEP, "chooser.put_to_sleep(x, y, moved), ", "", SLEEPS),
    "on the last side too, which may be the first": (
        SLEEP, "kTile : w.cells[kX] + 1 - first;", "kTile : w.cells[kX] - first;", SLEEPS),
    "what changes is looked at": ("../model/water_act.cpp", "depth : 0);\n    disturb(w, {i, j, 1, 1});", "depth : 0);", SLEEPS),
    "sources and forces keep awake": (SURVEY, "acts |= ", "acts = false && ", SLEEPS),
    "and sides": (SLEEP, "    chooser.mark_sides();\n", "", SLEEPS),
    "and hulls": (SLEEP, "    chooser.mark_hulls();\n", "", SLEEPS),
    "runs do not go round": (SLEEP, "        if (meets_seam()) wake_all();\n", "", SLEEPS),
    "what pressure holds up is at rest": (SURVEY, " += by_pressure * pressure[at + c];", " += 0 * pressure[at + c];", SLEEPS),
    "what is shallower than the height lies still": (SURVEY, "select((deep - least)", "select(deep", SLEEPS),
    "sheets whose steps differ are solved coupled": (
        "../model/membrane_limit.cpp", "!m.clock.all_alike(dt)", "false", ["stability_membrane_uneven"]),
    "in other things than their length too": (
        "../model/object.hh", " && !signbit(start)", "", ["stability_membrane_uneven"]),
    "sheets whose lines differ are solved coupled by default": (
        "../model/membrane_limit.cpp", "if (!separates) return CD_SOLVER_COUPLED;", "", ["physics_membrane_solver"]),
    "a plate's two V-cycles go both ways where one way leads astray": (
        "../solve/conjugate_gradients.cpp", "const bool astray = ", "const bool astray = false && ",
        ["stability_membrane_convergence"]),
    "what is held must not move": ("../model/sleep.cpp", " && !part.held(b, part, i)", " && i + 1 > 0", BODIES),
    "what moves wakes what it comes near": ("../model/sleep.cpp", "return !may_touch(it, x);", "return x != nullptr;", BODIES),
    "a step before it touches": ("../model/sleep.cpp", "> sqrt(speed) * dt", "> 0 * speed", BODIES),
    "beds that move wake all": ("../model/sleep.cpp", "!it.is_convex()", "it.callback", BODIES),
    "and callbacks": ("../model/sleep.hh", "return it.callback || ", "return ", BODIES),
    "time counts from the first step that ends slow": ("../model/sleep.cpp", "calm < 0 ? 0 : fmin", "fmin", BODIES),
    "what sleeps has stopped": (
        "../model/sleep.cpp", "if (!sleeps(b, part.number)) return;\n    part", "if (part.nodes > 0) return;\n    part", BODIES),
    "what is posed arrives": (
        "../model/body.hh", "set_number(b, b.position, at, get_number(b, b.target, at));", "(void)b, (void)at;", BODIES),
    "what breaks wakes": ("../model/chain_rope.cpp", "    wake(c, strand, 1);\n", "", BODIES),
    "and what tears": ("../model/membrane_step.cpp", "        if (m.broken > broken) wake(m);\n", "", BODIES),
    "nor does what a part of its way leaves out, or take any": (
        "rope_step.cpp", "seen.gained + size_of(nodes[i].ground", "seen.gained + size_of(0.0 * nodes[i].ground",
        ["physics_rope_pulleys"]),
    "as errors do, gaps count over lengths": (
        "rope_step.cpp", "(barrier * s.length - s.gap * s.next) / s.tension, on", "(barrier - s.gap * s.next) / s.tension, on",
        ["physics_rope_ends"]),
    "tensions tell what settled the velocities": (
        "rope_step.cpp", "select(solved, s.gap, L{})", "select(solved, L{}, L{})", ["physics_rope_winch"]),
    "but only after steps that were solved": (
        "rope_step.cpp", "? L::splat(stage.tolerance) - reached : L{};", "? one() : L{};", ["physics_rope_breaks"]),
    "where links push, what is added to masses calms Newton's method": (
        "rope_step.cpp", "select(reached - before, within(kRise * added, 1, kMostAdded), kFall * added)", "L{}",
        TOUCHES),
    "but is no more than rounding bears": ("rope_step.cpp", "kMostAdded = 1e6;", "kMostAdded = 1e300;", TOUCHES),
    "the interior point's barrier rises where an iteration is stuck": (
        "rope_step.cpp", "has_contacts() ? 1 / kBarrierFall : 1", "has_contacts() ? kBarrierFall : 1", ["physics_bed"]),
    "but, where nothing touches, at last stays where it is": (
        "rope_step.cpp", "k < kRises || has_contacts() ?", "true ?", ["physics_rope_air"]),
    "but not beyond what it was to begin with": (
        "rope_step.cpp", "barrier = smaller(wanted, highest)", "barrier = wanted", ["stability_ropes"]),
    "and stiff joints count for it": ("rope_step.cpp", "* bent() : L{}", "* L{} : L{}", ["stability_ropes"]),
    "the push on a rod's first node is found as others are": (
        "rope_rod.hh", "        if (has_contacts()) pressed(i, left);\n        if (i == 0) return;\n",
        "        if (i == 0) return;\n        if (has_contacts()) pressed(i, left);\n", TOUCHES),
    "where links push Newton's method goes on": (
        "rope_step.cpp", "stage.push ? stage.most_iterations : 0", "0", TOUCHES),
    "what a failed solve touches is looked at again": (
        "rope_step.cpp", "at < node_count * stage.collider_count && has_contacts()", "false", OVERLAPS),
    "but by pushes that mean nothing": ("rope_step.cpp", ", c.push = select(open, L{}, c.push);", ";", OVERLAPS),
    "and what is still inside came out by no more than it went": (
        "rope_step.cpp", "        c.before = select(open, L{} - came_out, c.before);\n", "", OVERLAPS),
    "and what it was outside of it did not meet": ("rope_step.cpp", "select(came_out, one(), L{})", "one()", OVERLAPS),
    "a curl turns with its rod": ("rope_rod.hh", "stage.curls ? joint.turn * along : along", "along", ["physics_rope_curl"]),
    "to the other side where it is solved from its end": (
        "rope_rod.hh", "comes_back[j] ? -1 : 1", "1", ["physics_rope_ends"]),
    "a rope's step makes no energy": (
        "rope_step.cpp", "share(seen.gained, worth + seen.rounding)", "L{}", ["stability_ropes"]),
    "the work of a winch is no energy made": (
        "rope_bundle.hh", "here.gained = here.gained - by_winch(s, stretch, dw)", "here.gained = here.gained",
        ["physics_rope_winch"]),
    "but errors of length are no winch": (
        "rope_step.cpp", "over - smaller(larger(over, L{} - error), error)", "over", ["physics_rope_winch"]),
    "no tension is more than springs did to nodes": (
        "rope_step.cpp", "larger(smaller(t, most), L{} - most)", "t", ["physics_rope_breaks"]),
    "what no tension holds breaks": (
        "../model/chain_rope.cpp", "i < c.springs && !solved; ++i", "i < c.springs && false; ++i", ["physics_rope_breaks"]),
    "at the weakest of the springs that pass it on": (
        "../model/chain_rope.cpp", "goes_on(first, first - 1)", "false", ["physics_rope_breaks"]),
    "beyond what rounding explains": (
        "../model/chain_rope.cpp", "c.rope.tolerance - rounded;", "c.rope.tolerance;", ["physics_rope_breaks"]),
    "springs that only pull push nothing": (
        "rope_step.cpp", "larger(seen.pushed, seen.slack * seen.lengths)", "seen.slack * seen.lengths",
        ["stability_ropes"]),
    "colliders that a node is not near do not push by the first guess": (
        "rope_contact.hh", "kNear = 1e-3;", "kNear = 1;", TOUCHES),
    "slack springs of the interior point bear no tension": (
        "rope_step.cpp", "larger(seen.pushed, seen.slack * seen.lengths)", "seen.pushed", ["stability_ropes"]),
    "what fails is tried with lambda = 1": (
        "rope_step.cpp", "    if (stage.lambda < 1) {\n        lambda = select", "    if (false) {\n        lambda = select",
        ["stability_ropes"]),
    "and by the interior point": (
        "rope_step.cpp", "    if (!stage.push) {\n        interior", "    if (false) {\n        interior", ["stability_ropes"]),
    "halves of a rope meet": ("rope_elimination.hh", "if (halved)", "if (false)", ["physics_rope_ends"]),
    "they have one sum of what is wrong": (
        "rope_bundle.hh", "L sum(L a) const { return halved ? a + pairs_exchanged(a) : a; }",
        "L sum(L a) const { return a; }", ["physics_rope_ends"]),
    "in which a spring in the middle counts once": (
        "rope_bundle.hh", "is_middle(i) ? here.half() : here", "here", ["physics_rope_ends"]),
    "what goes one way goes from the end that is held": (
        "rope_bundle.hh", "ends_held(last, j) && !ends_held(0, j)", "false", ["physics_rope_ends"]),
    "which begins from the common motion": ("rope_step.cpp", "    start_together();\n", "", ["stability_ropes"]),
    "with the force that held nodes bring": (
        "rope_step.cpp", "driven = driven + select(held(i), root(dot(n.b, n.b)), L{});", "", ["stability_ropes"]),
    "and that long springs pull with": ("rope_step.cpp", " + each * sum(pulled);", ";", ["stability_ropes"]),
    "the best that was found is kept": (
        "rope_step.cpp", "    const L better = best - reached;", "    const L better = one();", ["stability_ropes", "api_rope"]),
    "with no more energy than nodes have alone": ("rope_step.cpp", "    calm();\n}", "}", ["stability_ropes"]),
    "held nodes move as they are told whatever goes wrong": (
        "rope_step.cpp", "part * opposite(held(i));", "part;", ["stability_ropes"]),
    "no number, no solution": ("rope_bundle.hh", "here.probe = 0.0 * missing;", "", ["api_rope"]),
    "springs at their length count as taut at first": (
        "rope_step.cpp", "k < kFirstIterations ? kAsLong * stage.tolerance : 0", "0", ["physics_rope"]),
    "but those that push": ("rope_bundle.hh", "opposite(s.pushed), shorter", "one(), shorter", ["physics_rope"]),
    "velocities settle along taut springs": (
        "rope_step.cpp", "    if (stage.lambda < 1) { // what is caught", "    if (false) { // what is caught", ["physics_rope"]),
    "on the rate at which they lengthened": (
        "rope_step.cpp", "nodes[i].next) - wanted, none);", "nodes[i].next) - 0.0 * wanted, none);", ["physics_rope"]),
    "beyond what the tolerance explains": (
        "rope_step.cpp", "(moved - smaller(larger(moved, none - error), error))", "(moved - 0.0 * error)",
        ["stability_ropes"]),
    "also of springs that were slack": ("rope_step.cpp", "settle(one())", "settle(L{})", ["physics_rope_winch"]),
    "unless that makes energy": ("rope_step.cpp", "opposite(settle(one()))", "(settle(one()), one())", ["stability_ropes"]),
    "or as they are reeled in": ("rope_step.cpp", "none - positive(s.reeled)", "none", ["physics_rope_winch"]),
    "and softly, lest one settles by the others": (
        "rope_step.cpp", "constexpr double kSettleSoftly = 1e-12;", "constexpr double kSettleSoftly = 0;", ["stability_ropes"]),
    "springs that push do so midway": (
        "rope_bundle.hh", "by_sign(t, L::splat(0.5), lambda)", "lambda", ["stability_ropes"]),
    "tensions of rounding may be wrong": (
        "rope_step.cpp", "larger(weight, least_worth)", "weight", ["physics_rope_air"]),
    "air resists along the way of the middle of a step": (
        "rope_air.hh", "V chord = ((stage.dt * lambda) *", "V chord = (L{} *", ["physics_rope_air"]),
    "and no more than rounding bears": ("rope_air.hh", "double kMostAir = 1e10;", "double kMostAir = 1e60;", ["physics_rope_air"]),
    "the interior point knows the air's forces": (
        "rope_bundle.hh", "if (!has_air()) return own;", "return own;", ["physics_rope_air"]),
    "springs between held nodes are no part of the system": (
        "rope_bundle.hh", " * opposite(held(i) * held(i + 1));", ";", ["stability_ropes"]),
    "and count for no error": (
        "rope_bundle.hh", "rest(i), here = here.in(s.moves);", "rest(i);", ["stability_ropes", "determinism_parallel"]),
    "pushes act along the normal at the start": (
        "rope_contact.hh", "        const L changed =", "        c.acting = c.normal;\n        const L changed =",
        TOUCHES),
    "what lay inside is not thrown": ("rope_contact.hh", "        n.next = n.next - velocity_out(i);\n", "", TOUCHES),
    "and leaves several colliders together": ("collider.cpp", "b < a; ++b", "b < 0; ++b", OVERLAPS),
    "up to three": ("collider.cpp", "c <= b; ++c", "c < 1; ++c", OVERLAPS),
    "but not what has no edge": ("collider.cpp", "kFlat = 1e-6", "kFlat = -1", OVERLAPS),
    "and enters none that it meets on its way out": (
        "collider.cpp", "return of.on[k * of.contact_step + lane] > 0 &&", "return speed(k) > 0 &&", OVERLAPS),
    "and what lies on an axis across it": (
        "rope_contact.hh", "    way_off_line(to.way, ropes.components, out);\n", "    out[0] = 1;\n", OVERLAPS),
    "nor is its strand": ("rope_contact.hh", "if (!any_positive(lost)) return;", "return;", TOUCHES),
    "what yields takes energy": (
        "rope_bundle.hh", "here.gained = here.gained - by_yielding(s, stretch);", "(void)0;", ["physics_rope"]),
    "the linear system of a spring that turns keeps its answer": (
        "rope_bundle.hh", "(interior ? by_turning : by_turning / straight)", "by_turning", ["physics_rope"]),
    "what touches steps with lambda = 1": (
        "rope_step.cpp", "if (has_contacts() && stage.lambda < 1)", "if (false)", TOUCHES),
    "and was no solution before": (
        "rope_step.cpp", "reached = select(touched, L::splat(INFINITY), reached);", "", TOUCHES),
    "the push that is known makes up for the rest": (
        "rope_contact.hh", "leaving(i, c) + select(c.on, c.push / stiffness, L{})", "leaving(i, c)", TOUCHES),
    "Newton's method knows how friction depends on the slip": (
        "rope_contact.hh", "c.along = c.along * (one() - c.had), ", "", TOUCHES),
    "and on the push": ("rope_contact.hh", "c.follows = friction * slip / speed, ", "", TOUCHES),
    "about the friction that the last elimination had": (
        "rope_contact.hh", "select(was * (speed * most), share, law)", "law", TOUCHES),
    "what pushes lies at the surface": (
        "rope_contact.hh", "select(was, size_of(c.gap), positive(L{} - c.gap))", "positive(L{} - c.gap)", TOUCHES),
    "strands without mass touch nothing": (
        "rope_contact.hh", "select(c.on, c.push / stiffness, L{})", "c.push / stiffness", TOUCHES),
    "friction that does not settle is of the push found by then": (
        "rope_contact.hh", "kGripIterations = 50;", "kGripIterations = 10000;", TOUCHES),
    "friction is right to 1%": ("rope_contact.hh", "kFrictionError = 1e-2;", "kFrictionError = 1e2;", TOUCHES),
    "and sticks below a speed": ("rope_contact.hh", "kStickSpeed = 1e-4;", "kStickSpeed = 1e-2;", TOUCHES),
    "held nodes touch nothing": ("rope_contact.hh", "free = opposite(held(i));", "free = one();", TOUCHES),
    "loads go as far as the interior point goes": (
        "rope_step.cpp", "take_pushes(part);", "take_pushes(one());", ["physics_rope_loads"]),
    "what a node forgets was not given by what it came out of": (
        "collider.cpp", "of.rate * weight * of.normal[contact + c * of.lanes] + (weight", "(weight", ["physics_rope_loads"]),
    "nor what its strand loses": (
        "collider.cpp", "(weight > 0 ? weight / weights * slowed[c] : 0)", "0", ["physics_rope_loads"]),
    "of a step that was not solved no load is told": (
        "rope_contact.hh", "select(open, L{}, L::splat(1 / stage.dt) * per_lambda)", "(L::splat(1 / stage.dt) * per_lambda)",
        ["physics_rope_loads"]),
    "a joint of a cut spring has no bend": (
        "rope_rod.hh", "select(uncut(before) * uncut(link),", "select(one(),", ["physics_rope_bend"]),
    "a rod of uneven links is at rest where it is straight": (
        "rope_rod.hh", "    joint.ratio = link.length * before.per_length;\n", "", ["physics_rope_bend"]),
    "a stiff joint is not what is left of a difference": (
        "rope_rod.hh", "row(hung.c, k) = mobility * (row(yielding, k) + transposed_times(all, row(stiff, k)));",
        "row(hung.c, k) = row(M::diagonal(mobility), k) - (mobility * mobility) * row(stiff, k);",
        ["physics_rope_bend", "stability_ropes"]),
    "a bent rod at rest is solved for what changes": (
        "rope_rod.hh", "    else eliminate_change();\n", "    else eliminate_rod();\n", ["physics_rope_bend"]),
    "what joints make counts as energy made": (
        "rope_step.cpp", "    if (is_rod()) look_at_joints(seen);\n", "", ["stability_ropes"]),
    "slack springs have no tension after a step": (
        "rope_step.cpp", "select(slack, L{}, positive(tension))", "positive(tension)", ["physics_rope_bend"]),
    "what yields was taut if it was long": ("rope_step.cpp", "select(s.compliance, s.long_before - s.length, load_tension(i))",
        "load_tension(i)", ["physics_rope_winch"]),
    "taut is what its tension would take to its length": (
        "rope_step.cpp", "s.length - give(i) * s.tension", "s.length", ["physics_rope"]),
    "held nodes may be apart by what is rounded": ("rope_step.cpp", "(over - rounded)", "over", ["physics_rope_bend"]),
    "creases of beds are round": ("collider.hh", "kRoundCrease = 0.25;", "kRoundCrease = 1e-9;", ["physics_bed"]),
    "a hollow is met at the plane that touches it": (
        "rope_contact.hh", "if (to.is_convex()) return look_at_gap", "if (!to.callback) return look_at_gap",
        ["physics_bed"]),
    "a callback's normal has the length 1": (
        "collider.cpp", "kNormalError = 1e-3;", "kNormalError = 1e9;", ["api_bad_numbers"]),
    "hulls press through a skin": (HULL, "kStiff = 3;", "kStiff = 300;", ["physics_water_hulls", "stability_water_hulls"]),
    "drag weighs all of the water that moves": (
        "../model/water_hull_step.cpp", "moving_depth(w, a, i, j)", "face_depth(w, a, i, j)", ["stability_water_hulls"]),
    "that is stiffer than the water's surface": (
        HULL, "kStiff = 3;", "kStiff = 0.3;", ["physics_water_hulls", "stability_water_hulls"]),
    "in a long step all that is less than a depth above the water answers": (
        HULL_PLATES, "(run * depth <= 1 ? less", "(true ? less", ["stability_water_hulls"]),
    "lines that a hull presses dry are bound in their energy": (
        "water/sweep.cpp", "line.load[i] + (stiff - L::splat(2)) * d", "0.0 * d", ["stability_water_hulls"]),
    "and what air or wind presses dry": (
        "water/sweep.cpp", "line.acceleration && i < line.n", "false && i < line.n", ["stability_water_energy"]),
    "what drifting makes is owed": (HULL_STEP, "due = h.owed + more;", "due = 0 * more;", ["stability_water_hulls"]),
    "a hull owes a part of what it had before the push": (
        HULL_STEP, "kCredit * (had + energy);", "kCredit * (moving_energy() + energy + 0 * had);",
        ["stability_water_hulls"]),
    "and pays from three quarters of that on": (
        HULL_STEP, "kPaysFrom = 0.75;", "kPaysFrom = 0.5;", ["physics_water_hulls_glide"]),
    "a push that leads nowhere is not the water's": (
        HULL_STEP, "if (taken > removable() + credit) taken = lose(due);", "if (taken > removable() + credit) taken = due;",
        ["stability_water_hulls"]),
    "but is in its load": (
        HULL_STEP, "h.water[way] -= (1 - keeps) *", "h.water[way] -= (0 * keeps) *", ["physics_water_hulls"]),
    "a launched hull has displaced its water": (
        "../model/water_hull.cpp", "    sink(w, index, work);\n", "", ["physics_water_hulls"]),
    "and leaves no depth below 0": (
        "../model/water_hull.cpp", "has > 0 ? has : 0)", "has)", ["stability_water_volume"]),
    "a hull in the air comes down in any step": (
        HULL_STEP, "part * gain > least", "part > 0x1p-10", ["stability_water_hulls"]),
    "what bears a hull has no corners": (
        HULL_PLATES, "weight[0] = 0.5 * ((0.5 - off) * (0.5 - off)), weight[1] = 0.75 - off * off;\n"
        "    weight[2] = 0.5 * ((0.5 + off) * (0.5 + off));",
        "weight[0] = off < 0 ? -off : 0, weight[1] = 1 - fabs(off);\n    weight[2] = off > 0 ? off : 0;",
        ["physics_water_hulls"]),
    "hulls feel the slope of the water's head": (
        HULL_PLATES, "(along[k] * across[c]));", "(0 * across[c]));", ["physics_water_hulls"]),
    "what hulls press with, too": (HULL_STEP, " + (load(to) - load(from))", "", ["physics_water_hulls_glide"]),
    "where water gives way to it": (HULL_STEP, "mean(from) > 0 && mean(to) > 0 ?", "true ?", ["physics_water_hulls"]),
    "beyond a side slopes are mirrored": (HULL_PLATES, "> 0 ? -1 : 1;", "> 0 ? 1 : 1;", ["physics_water_hulls"]),
    "hulls stop before sides, and leave them": (HULL_PLATES, "kHullGap = 1;", "kHullGap = 0;", ["physics_water_hulls"]),
    "and before what closes their way": (
        HULL_STEP, "closed = is_near_closed(w, index, pose, cells_ahead(time));", "closed = false;", ["physics_water_hulls_walls"]),
    "through which they do not turn": (
        HULL_STEP, "if (closed && !can_turn", "if (false && !can_turn", ["physics_water_hulls_walls"]),
    "what stops a hull pays for what it owes": (
        HULL_STEP, "positive(due - (moving - moving_energy()))", "positive(due - 0 * moving)",
        ["physics_water_hulls_walls"]),
    "a wall parts a hull from the water behind": (
        "../model/water_hull_plates.cpp", "if (walls) mirror_at_walls(w, out);", "", ["physics_water_hulls_walls"]),
    "and from its slope": (
        HULL_PLATES, "if (w.wall[b] && cells[c] !=", "if (false && cells[c] !=", ["physics_water_hulls_walls"]),
    "and from its speed": (
        HULL_STEP, "if (lines[0] != lines[1] && walled", "if (false && walled", ["physics_water_hulls_walls"]),
    "friction holds a hull before it moves": (
        HULL_STEP, ", rubbed = rub(contact.by_bed);\n        drift(pose, before, made, rubbed, contact.energy);\n",
        ";\n        drift(pose, before, made, 0, contact.energy);\n        rub(contact.by_bed);\n", ["physics_water_hulls"]),
    "what friction takes pays for what drove a hull": (
        HULL_STEP, "positive(more - rubbed);", "positive(more);", ["physics_water_hulls"]),
    "a floor lies on its plane of least squares": (
        HULL_STEP, "xy = second[1] - mean[0] * first[1];", "xy = 0;", ["physics_water_hulls"]),
    "and has a slope along a line of plates": (
        HULL_STEP, "kLeastSpread = 1e-9;", "kLeastSpread = 0;", ["physics_water_hulls"]),
    "drag is the water's part": (
        HULL_STEP, "drag(1 - contact.by_bed / contact.push[0]);", "drag(1);", ["physics_water_hulls"]),
    "a hull at a wall is borne by the water along it": (
        HULL_PLATES, "round = periodic ? length : 2 * length;", "round = length;", ["physics_water_hulls"]),
    "stiff bend of a single line makes no forces": (
        "../model/membrane_work.cpp", "m.stiff_rod = has_bend(m) &&", "m.stiff_rod = false && has_bend(m) &&",
        ["stability_membrane_rigid"]),
    "but where it is held as a whole": (
        "../model/membrane_work.cpp", "&& !all_held &&", "&&", ["stability_membrane_rigid"]),
}
