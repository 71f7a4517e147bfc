# SPDX-License-Identifier: BSD-3-Clause
# Triaxial compression of a block between rough ends by FEMxDEM, as it comes
# with YADE and escript; to be run by YADE in a folder with 0.yade.gz of
# cell.py. The case comes from run.sh in the environment.
import resource
import sys
import types
from os import environ, sysconf

import numpy
import yade
import yade.utils
from esys.escript import *
from esys.escript.linearPDEs import LinearPDE
from esys.finley import Brick

# The package does not start by itself: it looks for a module `yadeimport`
# which nobody installs, and msFEM3D calls by short names what simDEM calls by
# long ones. Nothing else is changed.
yadeimport = types.ModuleType("yadeimport")
yadeimport.Omega = yade.Omega
yadeimport.utils = yade.utils
sys.modules["yadeimport"] = yadeimport
sys.path.insert(0, next(iter(yade.__path__)) + "/FEMxDEM")
import simDEM

for name in ("shear", "getStressAndTangent", "getVoidRatio", "avgRotation",
             "getFabric"):
    setattr(simDEM, name, getattr(simDEM, name + "3D"))
from msFEM3D import MultiScale

width, height, pressure, increment, tolerance = (
    float(environ[name])
    for name in ("width", "height", "pressure", "increment", "tolerance"))
steps, processes = (int(environ[name]) for name in ("steps", "processes"))


class Counted(MultiScale):
    """Counts how often all cells are evaluated."""

    updates = 0

    def applyStrain_getStressTangentDEM(self, st=Data()):
        self.updates += 1
        return super().applyStrain_getStressTangentDEM(st)


def cpu_seconds(pool):
    """User and system time of this process and of those of the pool [s]."""
    own = resource.getrusage(resource.RUSAGE_SELF)
    seconds = own.ru_utime + own.ru_stime
    for worker in pool._pool:
        words = open("/proc/%d/stat" % worker.pid).read().rsplit(")", 1)[1]
        user, system = words.split()[11:13]
        seconds += (int(user) + int(system)) / sysconf("SC_CLK_TCK")
    return seconds


domain = Brick(2, 2, 2, l0=width, l1=width, l2=height)
points = Function(domain).getX().getNumberOfDataPoints()
x = domain.getX()
held = (whereZero(x[2]) + whereZero(x[2] - height)) * [1, 1, 1]
moved = whereZero(x[2] - height) * [0, 0, -increment * height]
surface = FunctionOnBoundary(domain).getX()
confinement = pressure * (
    (whereZero(surface[0]) - whereZero(surface[0] - width)) * [1, 0, 0] +
    (whereZero(surface[1]) - whereZero(surface[1] - width)) * [0, 1, 0])
of_ends = numpy.array(held.toListOfTuples())[:, 2] > 0
of_top = numpy.array(whereZero(x[2] - height).toListOfTuples()) > 0

problem = Counted(domain, ng=points, np=processes, rtol=tolerance)
pool = problem._MultiScale__pool
# Of the forces alone, without anything held, to see what is unbalanced.
forces = LinearPDE(domain, numEquations=3, numSolutions=3)

for step in range(1, steps + 1):
    before = cpu_seconds(pool)
    problem.updates = 0
    problem.initialize(f=confinement, specified_u_mask=held,
                       specified_u_val=moved)
    problem.solve()
    seconds = cpu_seconds(pool) - before
    forces.setValue(A=problem.getCurrentTangent(),
                    X=-problem.getCurrentStress(), y=confinement)
    nodes = numpy.array(forces.getRightHandSide().toListOfTuples())
    unbalanced = numpy.linalg.norm(nodes[~of_ends])
    reactions = numpy.linalg.norm(nodes[of_ends, 2])
    print("step femxdem %d %d %.9g %.9g %.9g" %
          (step, problem.updates, seconds / points, unbalanced / reactions,
           nodes[of_top, 2].sum()), flush=True)
problem.exitSimulation()
