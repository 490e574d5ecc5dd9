"""Times Exudyn's ball-bearing contact on one bearing and prints a JSON object on one line.

Thirteen balls between two rings with grooves, a cage on springs, Hertzian normal stiffness, friction with a constant
coefficient at one point per contact. The outer ring stands, the inner ring turns at a given speed and carries a constant
load. Time is that of the integration alone, without building the model. Units: SI, angles in radians.
"""

import argparse
import json
import math
import time

import exudyn as exu
import numpy as np
from exudyn.machines import CreateBallBearing, GetBallBearingData
from exudyn.utilities import InertiaCylinder, MarkerBodyRigid


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--balls", type=int, required=True)
    parser.add_argument("--ball-diameter", type=float, required=True)
    parser.add_argument("--pitch-diameter", type=float, required=True)
    parser.add_argument("--inner-groove", type=float, required=True, help="groove radius over ball diameter")
    parser.add_argument("--outer-groove", type=float, required=True, help="groove radius over ball diameter")
    parser.add_argument("--contact-angle", type=float, required=True, help="free, rad")
    parser.add_argument("--stiffness", type=float, required=True, help="load over approach^1.5, N/m^1.5")
    parser.add_argument("--friction", type=float, default=0.1)
    parser.add_argument("--friction-zone", type=float, default=0.1, help="sliding speed of full friction, m/s")
    parser.add_argument("--ring-mass", type=float, default=12.0)
    parser.add_argument("--speed", type=float, required=True, help="inner ring, rad/s")
    parser.add_argument("--axial", type=float, required=True, help="N")
    parser.add_argument("--radial", type=float, required=True, help="N")
    parser.add_argument("--step", type=float, required=True, help="s")
    parser.add_argument("--duration", type=float, required=True, help="s")
    parser.add_argument("--settle", type=float, default=0.0, help="s integrated before the clock starts")
    return parser.parse_args()


def model(a):
    """The bearing; returns system, integrator settings, and sensors' bodies."""
    container = exu.SystemContainer()
    system = container.AddSystem()
    bore, outside = a.pitch_diameter - 1.6 * a.ball_diameter, a.pitch_diameter + 1.6 * a.ball_diameter
    data = GetBallBearingData(
        axis=[0, 0, 1],
        outsideDiameter=outside,
        boreDiameter=bore,
        width=1.4 * a.ball_diameter,
        nBalls=a.balls,
        radiusBalls=a.ball_diameter / 2,
        radiusCage=a.pitch_diameter / 2,
        innerGrooveRadius=a.inner_groove * a.ball_diameter,
        outerGrooveRadius=a.outer_groove * a.ball_diameter,
    )
    # All contacts begin just touching, at the free contact angle.
    inner, outer = (a.inner_groove - 0.5) * a.ball_diameter, (a.outer_groove - 0.5) * a.ball_diameter
    radially, axially = math.cos(a.contact_angle), math.sin(a.contact_angle)
    data["innerGrooveTorusRadius"] = a.pitch_diameter / 2 + inner * radially
    data["outerGrooveTorusRadius"] = a.pitch_diameter / 2 - outer * radially
    data["ballPositions"] = [place - np.array([0, 0, inner * axially]) for place in data["ballPositions"]]
    ring = system.CreateRigidBody(
        referencePosition=[0, 0, (inner + outer) * axially],
        inertia=InertiaCylinder(a.ring_mass / (math.pi * (bore / 2) ** 2 * 0.1), 0.1, bore / 2, axis=2),
        initialAngularVelocity=[0, 0, a.speed],
    )
    ground = system.CreateGround()
    # The shaft turns at a constant speed and moves freely; it does not tilt.
    system.CreateGenericJoint(itemNumbers=[ground, ring], position=[0, 0, 0], constrainedAxes=[0, 0, 0, 1, 1, 0])
    system.CreateForce(itemNumber=ring, loadVector=[a.radial, 0, a.axial])
    cage_speed = 0.5 * a.speed * (1 - a.ball_diameter / a.pitch_diameter)
    ball_speed = -0.5 * a.speed * (a.pitch_diameter / a.ball_diameter)
    bearing = CreateBallBearing(
        system,
        data,
        system.AddMarker(MarkerBodyRigid(bodyNumber=ring)),
        system.AddMarker(MarkerBodyRigid(bodyNumber=ground)),
        densityBalls=7800,
        densityCage=2000,
        cageInitialAngularVelocity=[0, 0, cage_speed],
        ballsInitialAngularVelocity=[0, 0, ball_speed],
        springStiffnessCage=1e5,
        springDampingCage=50,
        contactParametersRingBalls={
            "contactStiffness": a.stiffness,
            "contactDamping": 200,
            "dynamicFriction": a.friction,
            "frictionProportionalZone": a.friction_zone,
            "contactStiffnessExponent": 1.5,
        },
    )
    return system, ring, bearing


def settings(end, step):
    """The settings of a usual transient run: generalised-alpha, a fixed step, nothing written or printed."""
    chosen = exu.SimulationSettings()
    chosen.timeIntegration.endTime = end
    chosen.timeIntegration.numberOfSteps = max(1, round(end / step))
    chosen.timeIntegration.verboseMode = 0
    chosen.timeIntegration.newton.useModifiedNewton = True
    chosen.timeIntegration.generalizedAlpha.spectralRadius = 0.8
    chosen.timeIntegration.discontinuous.useRecommendedStepSize = False
    chosen.timeIntegration.discontinuous.ignoreMaxIterations = True
    chosen.timeIntegration.discontinuous.iterationTolerance = 0.1
    chosen.solution.file.write = False
    chosen.solution.sensors.writePeriod = end
    chosen.parallel.numberOfThreads = 1
    return chosen


def main():
    a = arguments()
    system, ring, bearing = model(a)
    system.Assemble()
    solver = exu.DynamicSolverType.GeneralizedAlpha
    if a.settle > 0:
        system.SolveDynamic(settings(a.settle, a.step), solverType=solver, updateInitialValues=True)
    wall, processor = time.perf_counter(), time.process_time()
    system.SolveDynamic(settings(a.duration, a.step), solverType=solver)
    wall, processor = time.perf_counter() - wall, time.process_time() - processor
    cage = system.GetObjectOutputBody(bearing["objectCage"], exu.OutputVariableType.AngularVelocity, [0, 0, 0])
    place = system.GetObjectOutputBody(ring, exu.OutputVariableType.Displacement, [0, 0, 0])
    answer = {
        "version": exu.__version__ if hasattr(exu, "__version__") else exu.config.Version(),
        "wall_s": wall,
        "processor_s": processor,
        "cage_speed_rpm": float(np.asarray(cage)[2]) * 30 / math.pi,
        "ring_displacement_um": [float(v) * 1e6 for v in place],
    }
    print(json.dumps(answer))


if __name__ == "__main__":
    main()
