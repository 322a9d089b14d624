"""The rules of cloth, as in rules.py."""

CLOTH, CLOTH_STEP = "../model/membrane_cloth.cpp", "../model/membrane_cloth_step.cpp"
CLOTH_ACT, CLOTH_PARTS = "../model/membrane_cloth_act.cpp", "../model/membrane_cloth_parts.cpp"
CLOTH_TEAR = "../model/membrane_cloth_tear.cpp"

CLOTH_RULES = {
    "a step of cloth begins where the last one went": (
        "../model/membrane_cloth_step.cpp", "w.moves[at] * change[i]", "0 * change[i]", ["physics_cloth_size"]),
    "and the preconditioner knows that direction": (
        "../model/membrane_cloth_step.cpp", "            if (recycles[i]) add", "            if (i > 0 && recycles[i]) add",
        ["physics_cloth_size"]),
    "and Newton's last one": (
        "../model/membrane_cloth_step.cpp", "recycle(first ? 0 : 1)", "first && recycle(0)", ["physics_cloth_size"]),
    "what is recycled counts where conjugate gradients are content": (
        "../model/membrane_cloth_step.cpp", "(known + size)", "size", ["physics_cloth_size"]),
    "conjugate gradients end where they bring little": (
        "../model/membrane_cloth_step.cpp", "lately < kLittle * brought", "false", ["physics_cloth_size"]),
    "and Newton's method goes on where it brings much": (
        "../model/membrane_cloth_step.cpp", "brings > kMuch * brought", "false", ["physics_cloth_size"]),
    "or more than its changes move with": (CLOTH_STEP, "(moving > 0 && brings > 0.5 * moving)", "false", ["physics_cloth_size"]),
    "a search ends where rounding is all that is left": (
        CLOTH_STEP, "return end <= -kFlat * falls ?", "return false ?", ["physics_cloth_motion"]),
    "unless that met a collider": (
        "../model/membrane_cloth_step.cpp", "if (touched || ", "if (", ["physics_cloth_contact"]),
    "what a free sheet's nodes lack counts, whether they touch or not": (
        CLOTH_ACT, " + w.mass[at] / bears[part] * vector_at(missing, part)", "", ["physics_cloth_loads"]),
    "but not a held one's": (CLOTH_ACT, "bears[part] = HUGE_VAL;", "(void)0;", ["physics_cloth_loads"]),
    "a step of cloth ends where it has made no energy": (
        CLOTH_STEP, "        add(share, way, w.w);\n", "", ["stability_cloth"]),
    "with the momentum that a free sheet has": (
        CLOTH_STEP, "free = share_momentum(w, contacts);", "free = false;", ["physics_cloth"]),
    "and in air and beside colliders": (
        CLOTH_STEP, "free = share_momentum(w, contacts);", "free = !w.has_blocks() && share_momentum(w, contacts);", ["physics_cloth_motion"]),
    "and each free part of a torn one": (
        CLOTH, "w.part[at] = joiner.first_of(at) + 1;", "w.part[at] = 1;", ["physics_cloth_motion"]),
    "and beside what moves, that goes along": (
        CLOTH_PARTS, "fmax(least, 0) + fmin(most, 0)", "0", ["physics_cloth_contact"]),
    "but only along the normals of what pushes": (
        CLOTH_ACT, "const double pushed = speed * c.normal[k];", "const double pushed = c.velocity[k] + 0 * speed;",
        ["physics_callback"]),
    "what rises by rounding only is gone all the way": (
        CLOTH_STEP, "            if (!(middle < most)) return most; // where it rises by rounding only\n",
        "            if (!(middle < most)) break;\n", ["physics_cloth_contact"]),
    "what the last iteration left is told": (
        CLOTH_STEP, "            if (i == most || !(size > 0) || !solve(i == 0)) break;",
        "            if (!(size > 0) || !solve(i == 0) || i + 1 >= most) break;", ["physics_cloth_motion"]),
    "cloth's friction goes by no more than a node needs to stay outside": (
        CLOTH_ACT, "solved && meets[j] ? fmin(now, push_of(of_node[j], velocity + by, inverse_dt)) : 0", "now",
        ["physics_cloth_contact"]),
    "a node on an axis has a way out": (
        CLOTH_ACT, "way_off_line(to.way, 3, gap.normal.k);", "gap.normal = {{1, 0, 0}};", ["physics_cloth_contact"]),
    "what can't go the whole way goes on": (
        CLOTH_STEP, "kMoreIterations = 4;", "kMoreIterations = 0;", ["physics_cloth_size"]),
    "what crumples is pushed as the step finds it": (
        CLOTH_STEP, "compression > 0) unfold();", "compression < 0) unfold();", ["physics_cloth"]),
    "and where it turns on as it does": (
        "cloth_springs.cpp", "length / larger(root(dot(moves, moves)), length) * moves", "L{} * moves",
        ["physics_cloth_motion"]),
    "and where an iteration finds that it leads": (
        CLOTH_STEP, "kExpectations = 3;", "kExpectations = 1;", ["physics_cloth_size"]),
    "but not for ever": (CLOTH_STEP, "kExpectations = 3;", "kExpectations = 1000;", ["physics_cloth_size"]),
    "but ways out of colliders are nothing that neighbours share": (
        CLOTH_STEP, "const bool out = CD_WITH_CONTACT && find_ways_out(w, contacts, dt);", "const bool out = false;",
        ["stability_cloth"]),
    "by no more than its length": (
        "cloth_springs.cpp", "length / larger(root(dot(moves, moves)), length) * moves", "moves",
        ["stability_cloth", "physics_cloth_motion", "physics_cloth_tears", "physics_cloth", "physics_cloth_size"]),
    "but not from node to node": ("cloth_springs.cpp", "L::splat(0.25)", "L{}", ["physics_cloth_size"]),
    "and what turns otherwise makes no energy": (
        CLOTH_STEP, "gained = m.cloth.compression > 0 ? m.lambda * gain() : 0;", "gained = 0;", ["stability_cloth"]),
    "nor leaves room for it": (
        CLOTH_STEP, "return gained > 0 ? falls +", "return share > 0 ? falls +", ["physics_cloth_motion"]),
    "springs that are nearly taut count": (
        "cloth_springs.cpp", "(excess * per_length) + L::splat(ahead), 0, 1)", "(excess * per_length), 0, 1)",
        ["physics_cloth_size"]),
    "but not so much of stiff cloth": (CLOTH_STEP, "kNearest = 0.1;", "kNearest = 1;", ["physics_cloth_size"]),
    "a spring of no length has no direction": (
        "cloth.hh", "kLeastDirection = 1e-6;", "kLeastDirection = 0;", ["stability_cloth"]),
    "a cut takes the shear of its cells with it": (
        CLOTH, "const double shear = whole ? m.cloth.shear : 0;", "const double shear = m.cloth.shear;", ["physics_cloth"]),
    "and the bend of its ends": (
        CLOTH, "return stiffness_of(m, d, u, v) > 0 && stiffness_of(m, d, last_u, last_v) > 0 ? bend : 0;",
        "return bend;", ["physics_cloth"]),
    "what cloth came out of does not throw it": (
        CLOTH_ACT, "fmax(out - overlap, fmin(out, own)) - now;", "out - now + 0 * (own + overlap);",
        ["physics_cloth_contact"]),
    "what is pushed leaves as fast as it moved": (
        CLOTH_ACT, "fmax(out - overlap, fmin(out, own)) - now;", "-overlap + 0 * (out + own + now);",
        ["physics_cloth_contact", "stability_cloth"]),
    "and no faster than it would have": (
        CLOTH_ACT, "square <= 2 * falls ? 1 :", "square > 0 ? 1 :", ["physics_cloth_pinched"]),
    "nor does it lose what it did not go": (
        CLOTH_ACT, "fmax(out - overlap, fmin(out, own)) - now;", "out - overlap - now + 0 * own;",
        ["physics_cloth_pinched"]),
    "what leaves several colliders leaves them together": (
        CLOTH_ACT, "kParallel = 1 - 1e-8;", "kParallel = 0;", ["physics_cloth_pinched"]),
    "cloth heeds several colliders": (
        "../model/membrane_cloth.hh", "kMostTouched = 3;", "kMostTouched = 1;", ["physics_cloth_contact"]),
    "what lies ahead before what is near": (
        CLOTH_ACT, "contact, dt * vector_at(w.w, at));", "contact, Vector3());", ["physics_cloth_contact"]),
    "friction of cloth resists no more than rounding bears": (
        CLOTH_ACT, "kMostFriction = 1e6;", "kMostFriction = 1e60;", ["physics_cloth_contact"]),
    "contacts of cloth yield little": (
        CLOTH_ACT, "kContactStiffness = 1e4,", "kContactStiffness = 1e2,", ["physics_cloth_contact"]),
    "and stick below a speed": (CLOTH_ACT, "kStickSpeed = 1e-3,", "kStickSpeed = 1e-1,", ["physics_cloth_contact"]),
    "a line of cloth's springs tears in one place of a step": (
        CLOTH_TEAR, "if (now > worst[line * stride]) worst[line * stride] = now, place[line * stride] = double(i);",
        "if (now > 1) m.spring_stiffness[d][at] = 0;", ["physics_cloth_tears"]),
    "beside a tear rather than where it is most overstrained": (
        CLOTH_TEAR, "worst[at * stride] > 1 && load(i, at) > 1", "false", ["physics_cloth_tears"]),
    "by multiples of what each spring bears": (
        CLOTH_TEAR, " / breaking_strain_of(m, d, u, v)", " - breaking_strain_of(m, d, u, v) + 1",
        ["physics_cloth_tears"]),
    "wind goes through what is torn open": (CLOTH_ACT, "!whole || is_open(m, u, v)", "!whole", ["physics_cloth_tears"]),
}
