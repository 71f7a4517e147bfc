# SPDX-License-Identifier: BSD-3-Clause
# The case of the peers, by YADE, whose input language this is. The case comes
# from run.sh in the environment.
from math import atan
from os import environ

youngs, poisson, density, friction, restitution, rate, dt, skin = (
    float(environ[name])
    for name in ("youngs", "poisson", "density", "friction", "restitution",
                 "rate", "dt", "skin"))

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
solid = sum(4 / 3 * pi * b.shape.radius**3 for b in O.bodies)

O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb()], verletDist=skin),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom()],
        [Ip2_FrictMat_FrictMat_MindlinPhys(en=restitution, es=restitution)],
        [Law2_ScGeom_MindlinPhys_Mindlin()]),
    NewtonIntegrator(damping=0),
]
O.dt = dt


def report():
    contacts = sum(1 for i in O.interactions if i.geom.penetrationDepth > 0)
    stress = getStress()
    print("state %.9g %.9g %.9g %.9g %.9g" %
          (solid / O.cell.volume, -stress[2][2], -stress[0][0], -stress[1][1],
           2 * contacts / len(O.bodies)), flush=True)


# A first step, without motion, makes the contacts.
O.dt = 1e-15
O.step()
O.dt = dt
report()
O.cell.velGrad = Matrix3(0, 0, 0, 0, 0, 0, 0, 0, -rate)
for steps in environ["steps"].split():
    O.run(int(steps), True)
    report()
