"""Jones-Harris equilibrium of the 218 bearing under pure thrust, in 40-digit arithmetic (Python 3 with mpmath).

Written apart from the Rust solver, from the equations alone: A. B. Jones, J. Basic Eng. 82 (1960) 309,
doi:10.1115/1.3662587, and the high-speed chapter of T. A. Harris, Rolling Bearing Analysis. All balls are alike, so
three unknowns remain: ball centre (axial, radial) from the outer groove centre, and axial ring displacement.
Outer raceway control, contact constants at the actual angle, centrifugal force at half the pitch diameter.

Run `python3 jones_harris_218.py > jones_harris_218.csv`.
"""

from mpmath import acos, cos, ellipe, ellipk, findroot, hypot, mp, mpf, pi, sin, sqrt

mp.dps = 40

BALLS, D, PITCH, F = 16, mpf("0.02223"), mpf("0.12526"), mpf("0.5232")
ANGLE, YOUNG, POISSON, DENSITY = 40 * pi / 180, mpf("206.9e9"), mpf("0.3"), mpf(7800)
THRUST, SPEED = mpf(22250), 10000 * pi / 30

MODULUS = YOUNG / (1 - POISSON**2)
MASS = DENSITY * pi * D**3 / 6
INERTIA = MASS * D**2 / 10
CENTRES, OFFSET, RATIO = (2 * F - 1) * D, (F - mpf(1) / 2) * D, D / PITCH


def hertz(cosine, side):
    """Stiffness, and the peak pressure over the cube root of the load, of a contact at the given cos(alpha)."""
    gamma = RATIO * cosine
    rolling = 2 / D + side * 2 / D * gamma / (1 - side * gamma)
    across = 2 / D - 1 / (F * D)
    total = rolling + across
    difference = (rolling - across) / total

    def wrong(k):
        m = 1 - 1 / k**2
        return ((k**2 + 1) * ellipe(m) - 2 * ellipk(m)) / ((k**2 - 1) * ellipe(m)) - difference

    k = findroot(wrong, (mpf(4), mpf(9)))
    m = 1 - 1 / k**2
    major = (6 * k**2 * ellipe(m) / (pi * MODULUS * total)) ** (mpf(1) / 3)
    approach = ellipk(m) * (9 * total / (2 * ellipe(m)) / (pi * k * MODULUS) ** 2) ** (mpf(1) / 3)
    return approach ** mpf("-1.5"), 3 * k / (2 * pi * major**2)


def state(x1, x2, z):
    a1, a2 = CENTRES * sin(ANGLE) + z, CENTRES * cos(ANGLE)
    lo, li = hypot(x1, x2), hypot(a1 - x1, a2 - x2)
    so, co, si, ci = x1 / lo, x2 / lo, (a1 - x1) / li, (a2 - x2) / li
    (ki, pi_), (ko, po) = hertz(ci, 1), hertz(co, -1)
    qi, qo = ki * (li - OFFSET) ** mpf("1.5"), ko * (lo - OFFSET) ** mpf("1.5")
    tan_beta = so / (co + RATIO)
    roll_i, roll_o = ci + tan_beta * si, co + tan_beta * so
    orbit = SPEED / (1 + (1 + RATIO * co) * roll_i / ((1 - RATIO * ci) * roll_o))
    axial = orbit * (1 + RATIO * co) / (RATIO * roll_o)
    moment = INERTIA * orbit * axial * tan_beta
    centrifugal = MASS * PITCH / 2 * orbit**2
    friction = 2 * moment / D
    balances = (
        qi * si - qo * so - friction * co,
        qi * ci - qo * co + friction * so + centrifugal,
        THRUST / BALLS - qi * si,
    )
    results = {
        "contact_angle_inner_deg": acos(ci) * 180 / pi,
        "contact_angle_outer_deg": acos(co) * 180 / pi,
        "load_inner_n": qi,
        "load_outer_n": qo,
        "peak_pressure_inner_pa": pi_ * qi ** (mpf(1) / 3),
        "peak_pressure_outer_pa": po * qo ** (mpf(1) / 3),
        "approach_inner_m": li - OFFSET,
        "approach_outer_m": lo - OFFSET,
        "orbital_speed_rad_s": orbit,
        "centrifugal_force_n": centrifugal,
        "gyroscopic_moment_nm": moment,
    }
    return balances, results, z


START = (OFFSET * sin(ANGLE), OFFSET * (cos(ANGLE) + mpf("0.02")), mpf("5e-5"))
ROOT = findroot(lambda *u: state(*u)[0], START, tol=mpf("1e-50"), maxsteps=200)
_, RESULTS, DISPLACEMENT = state(*ROOT)
print("# 218 angular-contact bearing, 22250 N thrust, 10000 r/min, Jones-Harris with outer raceway control.")
print("# Source: computed by jones_harris_218.py beside this file (mpmath, 40 digits). Uncertainty: below 1e-15 relative.")
print("# Units: as in the field names.")
print("field,value")
for name, value in RESULTS.items():
    print(f"{name},{mp.nstr(value, 17)}")
print(f"axial_displacement_m,{mp.nstr(DISPLACEMENT, 17)}")
