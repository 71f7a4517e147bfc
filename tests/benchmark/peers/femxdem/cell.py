# SPDX-License-Identifier: BSD-3-Clause
# Makes the unit cell of FEMxDEM, by YADE: the grains of a packing, in contact,
# as 0.yade.gz in the current folder. The case comes from run.sh in the
# environment.
from math import atan
from os import environ

youngs, poisson, density, friction = (
    float(environ[name])
    for name in ("youngs", "poisson", "density", "friction"))

O.materials.append(
    FrictMat(young=youngs, poisson=poisson, frictionAngle=atan(friction),
             density=density))
O.periodic = True
for line in open(environ["start"]):
    words = line.split()
    if words[:2] == ["#", "L"]:
        O.cell.setBox(*(float(word) for word in words[2:]))
    elif words and words[0] != "#":
        x, y, z, r = (float(word) for word in words)
        O.bodies.append(sphere((x, y, z), r))

O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb()]),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom()],
                    [Ip2_FrictMat_FrictMat_MindlinPhys()],
                    [Law2_ScGeom_MindlinPhys_Mindlin()]),
    NewtonIntegrator(damping=0.1),
]
# A first step, without motion, makes the contacts.
O.dt = 1e-15
O.step()
O.dt = PWaveTimeStep()
O.save("0.yade.gz")
