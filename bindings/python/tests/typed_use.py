"""Read by mypy, not run: what a user writes has the types that it should."""
from concurrent.futures import ThreadPoolExecutor

import contdyn
from contdyn import Array, Chain, Edge, Energy, Field, Membrane, Method, Node, Water


def use() -> float:
    with Chain(1, 10, 3) as rope:
        rope.method = Method.IMPLICIT
        rope.mass, rope.ring, rope.gravity = 1, True, (0, 0, -9.81)
        rope.position = [[0.0, 0.0, 0.0]] * 11
        shown: Array = rope.position
        energy: Energy = rope.energy
        rope.step(0.01)
        rope.parallel = ThreadPoolExecutor()
        rope.rest_length, rope.push, rope.tolerance = 1, True, (1e-8, 50)
        error: float = rope.convergence.residual + rope.tolerance.tolerance
        rope.air, rope.wind = (0.1, 1), (0, 0, 2)
        across: float = rope.air.across
        rope.strength = 100
        rope.teleport(0, None, (0, 0, 1))
        rope.colliders, rope.thickness = 1, 0.01
        rope.set_plane(0, (0, 0, -2), (0, 0, 1), 0.5)
        depth: float = rope.get_collider(0).first[2] + rope.thickness
        pull: float = rope.get_reaction(0, 0)[2] + rope.broken
    with Membrane(4, 4, 1) as drum:
        drum.stiffness = 20, 20
        drum.set_edge(Edge.U_FIRST, Node.POSED)
        drum.teleport([[1]], [0.5])
        along_u: float = drum.stiffness.along_u
    with Membrane(4, 4, 3) as cloth:
        cloth.rest_length, cloth.shear, cloth.effort = (1, 1), 100, (4, 20)
        cloth.breaking_strain = 0.5
        torn: int = cloth.broken
        cloth.air, cloth.wind, cloth.colliders = (0.1, 1), (0, 0, 2), 1
        cloth.set_capsule(0, (0, 0, 0), (0, 0, 1), 0.5)
        length: float = cloth.rest_length.along_u + cloth.get_collider(0).radius
        newton: int = cloth.effort.newton
    pool = Water(4, 4, 1, 1, contdyn.Precision.FLOAT32)
    pool.depth = 0.5
    added: float = pool.add_volume(1, 1, 1, 1)
    heights: Array = pool.sample([[1, 1]]).surface
    copy = pool.read(Field.DEPTH)
    return energy.kinetic + error + along_u + added + float(shown[0, 0, 0]) + float(heights[0]) + float(copy[0, 0])


def misuse() -> None:
    rope = Chain(1, 10, 3)
    rope.mass = "heavy"  # WRONG
    rope.method = Node.PINNED  # WRONG
    rope.energy = Energy(0, 0, 0)  # WRONG
    rope.step()  # WRONG
    rope.mas = 1  # WRONG
    Membrane(4, 4, 3).rest_length = 1  # WRONG
    rope.set_end("first", Node.PINNED)  # WRONG
    Water(4, 4, 1, 1).splash(1, 1, 1)  # WRONG
