"""Attributes of balls, solutions and recordings, by ``tools/quantities.py`` from the program's tables."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray


class BearingQuantities:
    """Quantities of the bearing in equilibrium."""

    #: Mean orbital speed of the balls, r/min
    cage_speed_rpm: float
    #: Displacement of the inner against the outer ring along X, m
    ring_displacement_x_m: float
    #: Displacement of the inner against the outer ring along Y, m
    ring_displacement_y_m: float
    #: Axial displacement of the inner against the outer ring, m
    ring_displacement_z_m: float
    #: Tilt of the inner ring about X, rad
    ring_tilt_x_rad: float
    #: Tilt of the inner ring about Y, rad
    ring_tilt_y_rad: float
    #: Force of the inner ring on the balls along X, N
    ring_load_x_n: float
    #: Force of the inner ring on the balls along Y, N
    ring_load_y_n: float
    #: Force of the inner ring on the balls along Z, N
    ring_load_z_n: float
    #: Moment of the inner ring on the balls about X, N m
    ring_moment_x_nm: float
    #: Moment of the inner ring on the balls about Y, N m
    ring_moment_y_nm: float
    #: Torque that the shaft needs, against rotation at the inner ring's speed, N m; with traction only
    shaft_torque_nm: float
    #: Speed of the inner ring, rad/s
    inner_speed_rad_s: float
    #: Speed of the outer ring, rad/s
    outer_speed_rad_s: float
    #: Quadrature error of the traction force over the load; with traction only
    patch_error_estimate: float


class BallQuantities:
    """Quantities of a ball and of its contacts."""

    #: Azimuth from X towards Y, °
    azimuth_deg: float
    #: Orbital speed ω_m, rad/s
    orbital_speed_rad_s: float
    #: Radius of the orbit of the ball centre about the bearing axis, m
    orbit_radius_m: float
    #: Orbit radius less half the pitch diameter, m
    radial_displacement_m: float
    #: Axial position of the ball centre against the unloaded one, m
    axial_displacement_m: float
    #: Angular velocity relative to the orbiting frame, axial component, rad/s
    angular_velocity_axial_rad_s: float
    #: Angular velocity relative to the orbiting frame, radial component, rad/s
    angular_velocity_radial_rad_s: float
    #: Angular velocity relative to the orbiting frame, tangential component, rad/s
    angular_velocity_tangential_rad_s: float
    #: Centrifugal force of the orbit, m r ω_m², N
    centrifugal_force_n: float
    #: Magnitude of the gyroscopic moment, N m
    gyroscopic_moment_nm: float
    #: Fluid drag, positive against the orbit, N; with traction only
    drag_n: float
    #: Moment of the fluid on the ball, axial component, N m; with traction only
    churning_axial_nm: float
    #: Moment of the fluid on the ball, radial component, N m; with traction only
    churning_radial_nm: float
    #: Moment of the fluid on the ball, tangential component, N m; with traction only
    churning_tangential_nm: float
    #: Power that churning takes from the absolute angular velocity, W; with traction only
    churning_w: float
    #: Power lost to drag, by the speed against the fluid, and churning, W; with traction only
    power_loss_fluid_w: float
    #: Lead of the ball over the middle of its cage pocket; negative where it lags, rad
    pocket_lead_rad: float
    #: Force of the cage pocket on the ball along the orbit; negative where it retards the ball, N
    pocket_force_n: float
    #: Archard wear rate of the cage pocket, m³/s
    wear_rate_cage_m3_s: float
    #: Friction of the cage pocket on the ball, axial component, N; of runs only
    pocket_friction_axial_n: float
    #: Friction of the cage pocket on the ball, radial component, N; of runs only
    pocket_friction_radial_n: float
    #: Orbital acceleration, rad/s²; of runs only
    orbital_acceleration_rad_s2: float
    #: Axial velocity of the ball centre, m/s; of runs only
    axial_velocity_m_s: float
    #: Radial velocity of the ball centre, m/s; of runs only
    radial_velocity_m_s: float
    #: Contact angle, °
    contact_angle_inner_deg: float
    #: Contact angle, °
    contact_angle_outer_deg: float
    #: Contact load Q of the elastic approach, N
    load_inner_n: float
    #: Contact load Q of the elastic approach, N
    load_outer_n: float
    #: Elastic approach of ball and race, m
    approach_inner_m: float
    #: Elastic approach of ball and race, m
    approach_outer_m: float
    #: Highest pressure in the contact, Pa
    peak_pressure_inner_pa: float
    #: Highest pressure in the contact, Pa
    peak_pressure_outer_pa: float
    #: Semi-axis of the contact ellipse across the groove, m
    semi_axis_across_inner_m: float
    #: Semi-axis of the contact ellipse across the groove, m
    semi_axis_across_outer_m: float
    #: Semi-axis of the contact ellipse along rolling, m
    semi_axis_rolling_inner_m: float
    #: Semi-axis of the contact ellipse along rolling, m
    semi_axis_rolling_outer_m: float
    #: Traction on the ball along the orbit, N; with traction only
    traction_inner_n: float
    #: Traction on the ball along the orbit, N; with traction only
    traction_outer_n: float
    #: Traction on the ball across the groove, N; with traction only
    lateral_traction_inner_n: float
    #: Traction on the ball across the groove, N; with traction only
    lateral_traction_outer_n: float
    #: Longitudinal sliding over rolling speed, ξ_x; positive where the ball is the faster; with traction only
    slide_to_roll_inner: float
    #: Longitudinal sliding over rolling speed, ξ_x; positive where the ball is the faster; with traction only
    slide_to_roll_outer: float
    #: Lateral sliding over rolling speed, ξ_y; with traction only
    lateral_slide_to_roll_inner: float
    #: Lateral sliding over rolling speed, ξ_y; with traction only
    lateral_slide_to_roll_outer: float
    #: Relative rotation about the contact normal over the rolling speed, φ, 1/m
    spin_ratio_inner_per_m: float
    #: Relative rotation about the contact normal over the rolling speed, φ, 1/m
    spin_ratio_outer_per_m: float
    #: Mean of the two surface speeds in the orbiting frame, V, m/s
    rolling_speed_inner_m_s: float
    #: Mean of the two surface speeds in the orbiting frame, V, m/s
    rolling_speed_outer_m_s: float
    #: Sliding speed, the mean over the contact weighted by pressure: V of a PV value, m/s; with traction only
    sliding_speed_inner_m_s: float
    #: Sliding speed, the mean over the contact weighted by pressure: V of a PV value, m/s; with traction only
    sliding_speed_outer_m_s: float
    #: Frictional power of the contact, W; with traction only
    power_loss_inner_w: float
    #: Frictional power of the contact, W; with traction only
    power_loss_outer_w: float
    #: Archard wear rate of the race, m³/s; with traction only
    wear_rate_inner_m3_s: float
    #: Archard wear rate of the race, m³/s; with traction only
    wear_rate_outer_m3_s: float
    #: Central thickness of the lubricant film, m; with a lubricant only
    film_central_inner_m: float
    #: Central thickness of the lubricant film, m; with a lubricant only
    film_central_outer_m: float
    #: Least thickness of the lubricant film, in its constriction, m; with a lubricant only
    film_minimum_inner_m: float
    #: Least thickness of the lubricant film, in its constriction, m; with a lubricant only
    film_minimum_outer_m: float
    #: Film parameter λ: least film thickness over the roughness of both bodies; with a lubricant only
    lambda_ratio_inner: float
    #: Film parameter λ: least film thickness over the roughness of both bodies; with a lubricant only
    lambda_ratio_outer: float
    #: Mean temperature of the film in the contact less that of its surroundings, K; with a lubricant only
    film_temperature_rise_inner_k: float
    #: Mean temperature of the film in the contact less that of its surroundings, K; with a lubricant only
    film_temperature_rise_outer_k: float
    #: Normal force on top of the load by the damping of the contact, N; of runs only
    damping_inner_n: float
    #: Normal force on top of the load by the damping of the contact, N; of runs only
    damping_outer_n: float
    #: Part of the coating that is gone where the ball stands; of runs only
    bare_inner: float
    #: Part of the coating that is gone where the ball stands; of runs only
    bare_outer: float
    #: Depth of the groove where the ball stands, by defects and wear, m; of runs only
    depth_inner_m: float
    #: Depth of the groove where the ball stands, by defects and wear, m; of runs only
    depth_outer_m: float


class BallArrays:
    """The same of all balls, an array each."""

    #: Azimuth from X towards Y, °
    azimuth_deg: NDArray[np.float64]
    #: Orbital speed ω_m, rad/s
    orbital_speed_rad_s: NDArray[np.float64]
    #: Radius of the orbit of the ball centre about the bearing axis, m
    orbit_radius_m: NDArray[np.float64]
    #: Orbit radius less half the pitch diameter, m
    radial_displacement_m: NDArray[np.float64]
    #: Axial position of the ball centre against the unloaded one, m
    axial_displacement_m: NDArray[np.float64]
    #: Angular velocity relative to the orbiting frame, axial component, rad/s
    angular_velocity_axial_rad_s: NDArray[np.float64]
    #: Angular velocity relative to the orbiting frame, radial component, rad/s
    angular_velocity_radial_rad_s: NDArray[np.float64]
    #: Angular velocity relative to the orbiting frame, tangential component, rad/s
    angular_velocity_tangential_rad_s: NDArray[np.float64]
    #: Centrifugal force of the orbit, m r ω_m², N
    centrifugal_force_n: NDArray[np.float64]
    #: Magnitude of the gyroscopic moment, N m
    gyroscopic_moment_nm: NDArray[np.float64]
    #: Fluid drag, positive against the orbit, N; with traction only
    drag_n: NDArray[np.float64]
    #: Moment of the fluid on the ball, axial component, N m; with traction only
    churning_axial_nm: NDArray[np.float64]
    #: Moment of the fluid on the ball, radial component, N m; with traction only
    churning_radial_nm: NDArray[np.float64]
    #: Moment of the fluid on the ball, tangential component, N m; with traction only
    churning_tangential_nm: NDArray[np.float64]
    #: Power that churning takes from the absolute angular velocity, W; with traction only
    churning_w: NDArray[np.float64]
    #: Power lost to drag, by the speed against the fluid, and churning, W; with traction only
    power_loss_fluid_w: NDArray[np.float64]
    #: Lead of the ball over the middle of its cage pocket; negative where it lags, rad
    pocket_lead_rad: NDArray[np.float64]
    #: Force of the cage pocket on the ball along the orbit; negative where it retards the ball, N
    pocket_force_n: NDArray[np.float64]
    #: Archard wear rate of the cage pocket, m³/s
    wear_rate_cage_m3_s: NDArray[np.float64]
    #: Friction of the cage pocket on the ball, axial component, N; of runs only
    pocket_friction_axial_n: NDArray[np.float64]
    #: Friction of the cage pocket on the ball, radial component, N; of runs only
    pocket_friction_radial_n: NDArray[np.float64]
    #: Orbital acceleration, rad/s²; of runs only
    orbital_acceleration_rad_s2: NDArray[np.float64]
    #: Axial velocity of the ball centre, m/s; of runs only
    axial_velocity_m_s: NDArray[np.float64]
    #: Radial velocity of the ball centre, m/s; of runs only
    radial_velocity_m_s: NDArray[np.float64]
    #: Contact angle, °
    contact_angle_inner_deg: NDArray[np.float64]
    #: Contact angle, °
    contact_angle_outer_deg: NDArray[np.float64]
    #: Contact load Q of the elastic approach, N
    load_inner_n: NDArray[np.float64]
    #: Contact load Q of the elastic approach, N
    load_outer_n: NDArray[np.float64]
    #: Elastic approach of ball and race, m
    approach_inner_m: NDArray[np.float64]
    #: Elastic approach of ball and race, m
    approach_outer_m: NDArray[np.float64]
    #: Highest pressure in the contact, Pa
    peak_pressure_inner_pa: NDArray[np.float64]
    #: Highest pressure in the contact, Pa
    peak_pressure_outer_pa: NDArray[np.float64]
    #: Semi-axis of the contact ellipse across the groove, m
    semi_axis_across_inner_m: NDArray[np.float64]
    #: Semi-axis of the contact ellipse across the groove, m
    semi_axis_across_outer_m: NDArray[np.float64]
    #: Semi-axis of the contact ellipse along rolling, m
    semi_axis_rolling_inner_m: NDArray[np.float64]
    #: Semi-axis of the contact ellipse along rolling, m
    semi_axis_rolling_outer_m: NDArray[np.float64]
    #: Traction on the ball along the orbit, N; with traction only
    traction_inner_n: NDArray[np.float64]
    #: Traction on the ball along the orbit, N; with traction only
    traction_outer_n: NDArray[np.float64]
    #: Traction on the ball across the groove, N; with traction only
    lateral_traction_inner_n: NDArray[np.float64]
    #: Traction on the ball across the groove, N; with traction only
    lateral_traction_outer_n: NDArray[np.float64]
    #: Longitudinal sliding over rolling speed, ξ_x; positive where the ball is the faster; with traction only
    slide_to_roll_inner: NDArray[np.float64]
    #: Longitudinal sliding over rolling speed, ξ_x; positive where the ball is the faster; with traction only
    slide_to_roll_outer: NDArray[np.float64]
    #: Lateral sliding over rolling speed, ξ_y; with traction only
    lateral_slide_to_roll_inner: NDArray[np.float64]
    #: Lateral sliding over rolling speed, ξ_y; with traction only
    lateral_slide_to_roll_outer: NDArray[np.float64]
    #: Relative rotation about the contact normal over the rolling speed, φ, 1/m
    spin_ratio_inner_per_m: NDArray[np.float64]
    #: Relative rotation about the contact normal over the rolling speed, φ, 1/m
    spin_ratio_outer_per_m: NDArray[np.float64]
    #: Mean of the two surface speeds in the orbiting frame, V, m/s
    rolling_speed_inner_m_s: NDArray[np.float64]
    #: Mean of the two surface speeds in the orbiting frame, V, m/s
    rolling_speed_outer_m_s: NDArray[np.float64]
    #: Sliding speed, the mean over the contact weighted by pressure: V of a PV value, m/s; with traction only
    sliding_speed_inner_m_s: NDArray[np.float64]
    #: Sliding speed, the mean over the contact weighted by pressure: V of a PV value, m/s; with traction only
    sliding_speed_outer_m_s: NDArray[np.float64]
    #: Frictional power of the contact, W; with traction only
    power_loss_inner_w: NDArray[np.float64]
    #: Frictional power of the contact, W; with traction only
    power_loss_outer_w: NDArray[np.float64]
    #: Archard wear rate of the race, m³/s; with traction only
    wear_rate_inner_m3_s: NDArray[np.float64]
    #: Archard wear rate of the race, m³/s; with traction only
    wear_rate_outer_m3_s: NDArray[np.float64]
    #: Central thickness of the lubricant film, m; with a lubricant only
    film_central_inner_m: NDArray[np.float64]
    #: Central thickness of the lubricant film, m; with a lubricant only
    film_central_outer_m: NDArray[np.float64]
    #: Least thickness of the lubricant film, in its constriction, m; with a lubricant only
    film_minimum_inner_m: NDArray[np.float64]
    #: Least thickness of the lubricant film, in its constriction, m; with a lubricant only
    film_minimum_outer_m: NDArray[np.float64]
    #: Film parameter λ: least film thickness over the roughness of both bodies; with a lubricant only
    lambda_ratio_inner: NDArray[np.float64]
    #: Film parameter λ: least film thickness over the roughness of both bodies; with a lubricant only
    lambda_ratio_outer: NDArray[np.float64]
    #: Mean temperature of the film in the contact less that of its surroundings, K; with a lubricant only
    film_temperature_rise_inner_k: NDArray[np.float64]
    #: Mean temperature of the film in the contact less that of its surroundings, K; with a lubricant only
    film_temperature_rise_outer_k: NDArray[np.float64]
    #: Normal force on top of the load by the damping of the contact, N; of runs only
    damping_inner_n: NDArray[np.float64]
    #: Normal force on top of the load by the damping of the contact, N; of runs only
    damping_outer_n: NDArray[np.float64]
    #: Part of the coating that is gone where the ball stands; of runs only
    bare_inner: NDArray[np.float64]
    #: Part of the coating that is gone where the ball stands; of runs only
    bare_outer: NDArray[np.float64]
    #: Depth of the groove where the ball stands, by defects and wear, m; of runs only
    depth_inner_m: NDArray[np.float64]
    #: Depth of the groove where the ball stands, by defects and wear, m; of runs only
    depth_outer_m: NDArray[np.float64]


class StateArrays:
    """Rings, cage and powers of a run, over time."""

    #: Simulated time, s
    time_s: NDArray[np.float64]
    #: Angle of the cage, 0 to 360, degrees
    cage_angle_deg: NDArray[np.float64]
    #: Angle of the inner ring, 0 to 360, degrees
    shaft_angle_deg: NDArray[np.float64]
    #: Displacement of the inner ring along X, micrometres
    inner_displacement_x_um: NDArray[np.float64]
    #: Displacement of the inner ring along Y, micrometres
    inner_displacement_y_um: NDArray[np.float64]
    #: Displacement of the inner ring along Z, micrometres
    inner_displacement_z_um: NDArray[np.float64]
    #: Velocity of the inner ring along X, mm/s
    inner_velocity_x_mm_s: NDArray[np.float64]
    #: Velocity of the inner ring along Y, mm/s
    inner_velocity_y_mm_s: NDArray[np.float64]
    #: Velocity of the inner ring along Z, mm/s
    inner_velocity_z_mm_s: NDArray[np.float64]
    #: Acceleration of the inner ring along X, low-pass filtered and delayed as the metadata say, m/s²
    inner_acceleration_x_m_s2: NDArray[np.float64]
    #: Acceleration of the inner ring along Y, low-pass filtered and delayed as the metadata say, m/s²
    inner_acceleration_y_m_s2: NDArray[np.float64]
    #: Acceleration of the inner ring along Z, low-pass filtered and delayed as the metadata say, m/s²
    inner_acceleration_z_m_s2: NDArray[np.float64]
    #: Sum of the ball forces on the inner ring along X, N
    inner_ball_force_x_n: NDArray[np.float64]
    #: Sum of the ball forces on the inner ring along Y, N
    inner_ball_force_y_n: NDArray[np.float64]
    #: Sum of the ball forces on the inner ring along Z, N
    inner_ball_force_z_n: NDArray[np.float64]
    #: Displacement of the outer ring along X, micrometres
    outer_displacement_x_um: NDArray[np.float64]
    #: Displacement of the outer ring along Y, micrometres
    outer_displacement_y_um: NDArray[np.float64]
    #: Displacement of the outer ring along Z, micrometres
    outer_displacement_z_um: NDArray[np.float64]
    #: Velocity of the outer ring along X, mm/s
    outer_velocity_x_mm_s: NDArray[np.float64]
    #: Velocity of the outer ring along Y, mm/s
    outer_velocity_y_mm_s: NDArray[np.float64]
    #: Velocity of the outer ring along Z, mm/s
    outer_velocity_z_mm_s: NDArray[np.float64]
    #: Acceleration of the outer ring along X, low-pass filtered and delayed as the metadata say, m/s²
    outer_acceleration_x_m_s2: NDArray[np.float64]
    #: Acceleration of the outer ring along Y, low-pass filtered and delayed as the metadata say, m/s²
    outer_acceleration_y_m_s2: NDArray[np.float64]
    #: Acceleration of the outer ring along Z, low-pass filtered and delayed as the metadata say, m/s²
    outer_acceleration_z_m_s2: NDArray[np.float64]
    #: Sum of the ball forces on the outer ring along X, N
    outer_ball_force_x_n: NDArray[np.float64]
    #: Sum of the ball forces on the outer ring along Y, N
    outer_ball_force_y_n: NDArray[np.float64]
    #: Sum of the ball forces on the outer ring along Z, N
    outer_ball_force_z_n: NDArray[np.float64]
    #: Speed of the inner ring, r/min
    inner_speed_rpm: NDArray[np.float64]
    #: Speed of the outer ring, r/min
    outer_speed_rpm: NDArray[np.float64]
    #: Torque about Z that keeps the speed of the inner ring, N m
    inner_torque_nm: NDArray[np.float64]
    #: Torque about Z that keeps the speed of the outer ring, N m
    outer_torque_nm: NDArray[np.float64]
    #: Speed of the cage, r/min
    cage_speed_rpm: NDArray[np.float64]
    #: Mean orbital speed of the balls, r/min
    orbital_speed_mean_rpm: NDArray[np.float64]
    #: Lowest orbital speed of any ball, r/min
    orbital_speed_min_rpm: NDArray[np.float64]
    #: Highest orbital speed of any ball, r/min
    orbital_speed_max_rpm: NDArray[np.float64]
    #: Rotational acceleration of the cage, rad/s²
    cage_acceleration_rad_s2: NDArray[np.float64]
    #: Torque of all balls on the cage, N mm
    cage_ball_torque_nmm: NDArray[np.float64]
    #: Torque of drag and guidance on the cage, N mm
    cage_fluid_torque_nmm: NDArray[np.float64]
    #: Power of the drives of both rings, W
    shaft_w: NDArray[np.float64]
    #: Power of the external loads on the rings, W
    load_w: NDArray[np.float64]
    #: Frictional power of all inner contacts, W
    friction_inner_w: NDArray[np.float64]
    #: Frictional power of all outer contacts, W
    friction_outer_w: NDArray[np.float64]
    #: Power taken by the drag on the balls, W
    drag_w: NDArray[np.float64]
    #: Power taken by the churning of the balls, W
    churning_w: NDArray[np.float64]
    #: Power taken by the damping of the ball–race contacts, W
    contact_damping_w: NDArray[np.float64]
    #: Power taken by friction in the cage pockets, W
    pocket_friction_w: NDArray[np.float64]
    #: Power taken by damping in the cage pockets, W
    pocket_damping_w: NDArray[np.float64]
    #: Power taken by drag and guidance of the cage, W
    cage_w: NDArray[np.float64]
    #: Power taken by the dampers of the supports, W
    support_w: NDArray[np.float64]
    #: Kinetic and elastic energy, J
    energy_j: NDArray[np.float64]
    #: What is missing in the energy balance from the start over the work put in, parts per billion
    imbalance_ppb: NDArray[np.float64]
    #: Largest inner contact load of any ball, N
    load_inner_max_n: NDArray[np.float64]
    #: Largest outer contact load of any ball, N
    load_outer_max_n: NDArray[np.float64]
    #: Largest inner peak pressure of any ball, GPa
    peak_pressure_inner_max_gpa: NDArray[np.float64]
    #: Largest outer peak pressure of any ball, GPa
    peak_pressure_outer_max_gpa: NDArray[np.float64]
    #: Largest magnitude of any pocket force, N
    pocket_force_max_n: NDArray[np.float64]
    #: Displacement of the cage's centre along X, micrometres
    cage_x_um: NDArray[np.float64]
    #: Displacement of the cage's centre along Y, micrometres
    cage_y_um: NDArray[np.float64]
    #: Displacement of the cage's centre along the axis, micrometres
    cage_z_um: NDArray[np.float64]
    #: Tilt of the cage about X, mrad
    cage_tilt_x_mrad: NDArray[np.float64]
    #: Tilt of the cage about Y, mrad
    cage_tilt_y_mrad: NDArray[np.float64]
    #: Force of the inner ring's lands on the cage along X, N
    land_inner_x_n: NDArray[np.float64]
    #: Force of the inner ring's lands on the cage along Y, N
    land_inner_y_n: NDArray[np.float64]
    #: Force of the outer ring's lands on the cage along X, N
    land_outer_x_n: NDArray[np.float64]
    #: Force of the outer ring's lands on the cage along Y, N
    land_outer_y_n: NDArray[np.float64]
    #: Smallest gap between cage and lands, micrometres, negative where an edge is pressed; 0 without lands
    land_gap_um: NDArray[np.float64]
    #: Power taken by friction at the cage's lands, a part of that of drag and guidance, W
    land_friction_w: NDArray[np.float64]
    #: Power taken by the films of the cage's lands, a part of that of drag and guidance, W
    land_film_w: NDArray[np.float64]
    #: Tilt of the inner ring about X, mrad
    inner_tilt_x_mrad: NDArray[np.float64]
    #: Tilt of the inner ring about Y, mrad
    inner_tilt_y_mrad: NDArray[np.float64]
    #: Tilt of the outer ring about X, mrad
    outer_tilt_x_mrad: NDArray[np.float64]
    #: Tilt of the outer ring about Y, mrad
    outer_tilt_y_mrad: NDArray[np.float64]


class SolutionArrays:
    """The bearing of a recorded solution."""

    #: Simulated time, s
    time_s: NDArray[np.float64]
    #: Angle of the cage, 0 to 360, degrees
    cage_angle_deg: NDArray[np.float64]
    #: Angle of the inner ring, 0 to 360, degrees
    shaft_angle_deg: NDArray[np.float64]
    #: Displacement of the inner ring along X, micrometres
    ring_displacement_x_um: NDArray[np.float64]
    #: Displacement of the inner ring along Y, micrometres
    ring_displacement_y_um: NDArray[np.float64]
    #: Axial displacement of the inner ring, micrometres
    ring_displacement_z_um: NDArray[np.float64]
    #: Tilt of the inner ring about X, mrad
    ring_tilt_x_mrad: NDArray[np.float64]
    #: Tilt of the inner ring about Y, mrad
    ring_tilt_y_mrad: NDArray[np.float64]
    #: Mean orbital speed of the balls, r/min
    cage_speed_rpm: NDArray[np.float64]
    #: Speed of the inner ring, r/min
    inner_speed_rpm: NDArray[np.float64]
    #: Speed of the outer ring, r/min
    outer_speed_rpm: NDArray[np.float64]
    #: Torque that the shaft needs, N m
    shaft_torque_nm: NDArray[np.float64]
    #: Force of the inner ring on the balls along X, N
    ring_load_x_n: NDArray[np.float64]
    #: Force of the inner ring on the balls along Y, N
    ring_load_y_n: NDArray[np.float64]
    #: Force of the inner ring on the balls along Z, N
    ring_load_z_n: NDArray[np.float64]
    #: Moment of the inner ring on the balls about X, N m
    ring_moment_x_nm: NDArray[np.float64]
    #: Moment of the inner ring on the balls about Y, N m
    ring_moment_y_nm: NDArray[np.float64]
    #: Frictional power of all inner contacts, W
    power_loss_inner_w: NDArray[np.float64]
    #: Frictional power of all outer contacts, W
    power_loss_outer_w: NDArray[np.float64]
    #: Power taken by drag and churning of all balls, W
    power_loss_fluid_w: NDArray[np.float64]
    #: Largest inner contact load of any ball, N
    load_inner_max_n: NDArray[np.float64]
    #: Largest outer contact load of any ball, N
    load_outer_max_n: NDArray[np.float64]
    #: Largest inner peak pressure of any ball, GPa
    peak_pressure_inner_max_gpa: NDArray[np.float64]
    #: Largest outer peak pressure of any ball, GPa
    peak_pressure_outer_max_gpa: NDArray[np.float64]
    #: Lowest orbital speed of any ball, r/min
    orbital_speed_min_rpm: NDArray[np.float64]
    #: Highest orbital speed of any ball, r/min
    orbital_speed_max_rpm: NDArray[np.float64]
    #: Wear rate of the inner race, cubic micrometres per second
    wear_rate_inner_um3_s: NDArray[np.float64]
    #: Wear rate of the outer race, cubic micrometres per second
    wear_rate_outer_um3_s: NDArray[np.float64]
    #: Wear rate of the cage, cubic micrometres per second
    wear_rate_cage_um3_s: NDArray[np.float64]


class WornArrays:
    """What has worn off, over time."""

    #: Simulated time, s
    time_s: NDArray[np.float64]
    #: Volume off the inner race, cubic micrometres
    volume_inner_um3: NDArray[np.float64]
    #: Volume off the outer race, cubic micrometres
    volume_outer_um3: NDArray[np.float64]
    #: Volume off the cage pockets, cubic micrometres
    volume_cage_um3: NDArray[np.float64]
    #: Thinnest coating left on the inner race, micrometres
    coating_inner_min_um: NDArray[np.float64]
    #: Thinnest coating left on the outer race, micrometres
    coating_outer_min_um: NDArray[np.float64]


class RecordedBallArrays:
    """Numbers of all balls, by time and ball."""

    #: Azimuth from X towards Y, 0 to 360, degrees
    azimuth_deg: NDArray[np.float32]
    #: Contact angle at the inner race, degrees
    contact_angle_inner_deg: NDArray[np.float32]
    #: Contact angle at the outer race, degrees
    contact_angle_outer_deg: NDArray[np.float32]
    #: Contact load at the inner race, N
    load_inner_n: NDArray[np.float32]
    #: Contact load at the outer race, N
    load_outer_n: NDArray[np.float32]
    #: Elastic approach at the inner race, micrometres
    approach_inner_um: NDArray[np.float32]
    #: Elastic approach at the outer race, micrometres
    approach_outer_um: NDArray[np.float32]
    #: Peak contact pressure at the inner race, GPa
    peak_pressure_inner_gpa: NDArray[np.float32]
    #: Peak contact pressure at the outer race, GPa
    peak_pressure_outer_gpa: NDArray[np.float32]
    #: Semi-axis of the inner contact across the groove, mm
    semi_axis_across_inner_mm: NDArray[np.float32]
    #: Semi-axis of the inner contact along rolling, mm
    semi_axis_rolling_inner_mm: NDArray[np.float32]
    #: Semi-axis of the outer contact across the groove, mm
    semi_axis_across_outer_mm: NDArray[np.float32]
    #: Semi-axis of the outer contact along rolling, mm
    semi_axis_rolling_outer_mm: NDArray[np.float32]
    #: Orbital speed of the ball, r/min
    orbital_speed_rpm: NDArray[np.float32]
    #: Orbit radius less half the pitch diameter, micrometres
    radial_displacement_um: NDArray[np.float32]
    #: Axial position of the ball centre against the unloaded one, micrometres
    axial_displacement_um: NDArray[np.float32]
    #: Spin relative to the orbiting frame, axial component, rad/s
    angular_velocity_axial_rad_s: NDArray[np.float32]
    #: Spin relative to the orbiting frame, radial component, rad/s
    angular_velocity_radial_rad_s: NDArray[np.float32]
    #: Spin relative to the orbiting frame, tangential component, rad/s
    angular_velocity_tangential_rad_s: NDArray[np.float32]
    #: Centrifugal force, N
    centrifugal_force_n: NDArray[np.float32]
    #: Gyroscopic moment (magnitude), N mm
    gyroscopic_moment_nmm: NDArray[np.float32]
    #: Fluid drag, N, positive against the orbit
    drag_n: NDArray[np.float32]
    #: Traction on the ball along the orbit at the inner race, N
    traction_inner_n: NDArray[np.float32]
    #: Traction on the ball along the orbit at the outer race, N
    traction_outer_n: NDArray[np.float32]
    #: Lateral traction on the ball at the inner race, N
    lateral_traction_inner_n: NDArray[np.float32]
    #: Lateral traction on the ball at the outer race, N
    lateral_traction_outer_n: NDArray[np.float32]
    #: Longitudinal slide-to-roll ratio at the inner race, percent
    slide_to_roll_inner_percent: NDArray[np.float32]
    #: Longitudinal slide-to-roll ratio at the outer race, percent
    slide_to_roll_outer_percent: NDArray[np.float32]
    #: Lateral slide-to-roll ratio at the inner race, percent
    lateral_slide_to_roll_inner_percent: NDArray[np.float32]
    #: Lateral slide-to-roll ratio at the outer race, percent
    lateral_slide_to_roll_outer_percent: NDArray[np.float32]
    #: Spin ratio at the inner race, 1/m
    spin_ratio_inner_per_m: NDArray[np.float32]
    #: Spin ratio at the outer race, 1/m
    spin_ratio_outer_per_m: NDArray[np.float32]
    #: Rolling speed at the inner race, m/s
    rolling_speed_inner_m_s: NDArray[np.float32]
    #: Rolling speed at the outer race, m/s
    rolling_speed_outer_m_s: NDArray[np.float32]
    #: Frictional power at the inner race, W
    power_loss_inner_w: NDArray[np.float32]
    #: Frictional power at the outer race, W
    power_loss_outer_w: NDArray[np.float32]
    #: Power taken by drag and churning, W
    power_loss_fluid_w: NDArray[np.float32]
    #: Archard wear rate at the inner race, cubic micrometres per second
    wear_rate_inner_um3_s: NDArray[np.float32]
    #: Archard wear rate at the outer race, cubic micrometres per second
    wear_rate_outer_um3_s: NDArray[np.float32]
    #: Lead of the ball over its cage pocket, mrad (negative: it lags)
    pocket_lead_mrad: NDArray[np.float32]
    #: Cage pocket force on the ball along the orbit, N
    pocket_force_n: NDArray[np.float32]
    #: Archard wear rate at the cage pocket, cubic micrometres per second
    wear_rate_cage_um3_s: NDArray[np.float32]
    #: Orbital acceleration, rad/s²; from here to the depths fields of transient runs only
    orbital_acceleration_rad_s2: NDArray[np.float32]
    #: Axial velocity of the ball centre, mm/s
    axial_velocity_mm_s: NDArray[np.float32]
    #: Radial velocity of the ball centre, mm/s
    radial_velocity_mm_s: NDArray[np.float32]
    #: Damping force at the inner race, on top of the contact load, N
    damping_inner_n: NDArray[np.float32]
    #: Damping force at the outer race, on top of the contact load, N
    damping_outer_n: NDArray[np.float32]
    #: Friction of the pocket on the ball, axial, N
    pocket_friction_axial_n: NDArray[np.float32]
    #: Friction of the pocket on the ball, radial, N
    pocket_friction_radial_n: NDArray[np.float32]
    #: Part of the coating that is gone at the inner race where the ball stands, percent
    bare_inner_percent: NDArray[np.float32]
    #: Part of the coating that is gone at the outer race where the ball stands, percent
    bare_outer_percent: NDArray[np.float32]
    #: Depth of the inner groove where the ball stands, by defects and wear, micrometres
    depth_inner_um: NDArray[np.float32]
    #: Depth of the outer groove where the ball stands, by defects and wear, micrometres
    depth_outer_um: NDArray[np.float32]
    #: Power that churning takes from the rotation, W
    churning_w: NDArray[np.float32]
    #: Radius of the orbit of the ball centre about the bearing axis, mm
    orbit_radius_mm: NDArray[np.float32]
    #: Moment of the fluid on the ball, axial, N mm
    churning_axial_nmm: NDArray[np.float32]
    #: Moment of the fluid on the ball, radial, N mm
    churning_radial_nmm: NDArray[np.float32]
    #: Moment of the fluid on the ball, tangential, N mm
    churning_tangential_nmm: NDArray[np.float32]
    #: Sliding speed at the inner race, mean over the contact weighted by pressure, m/s
    sliding_speed_inner_m_s: NDArray[np.float32]
    #: Sliding speed at the outer race, mean over the contact weighted by pressure, m/s
    sliding_speed_outer_m_s: NDArray[np.float32]
    #: Central thickness of the lubricant film at the inner race, µm; 0 without a film
    film_central_inner_um: NDArray[np.float32]
    #: Central thickness of the lubricant film at the outer race, µm; 0 without a film
    film_central_outer_um: NDArray[np.float32]
    #: Least thickness of the lubricant film at the inner race, µm; 0 without a film
    film_minimum_inner_um: NDArray[np.float32]
    #: Least thickness of the lubricant film at the outer race, µm; 0 without a film
    film_minimum_outer_um: NDArray[np.float32]
    #: Film parameter λ at the inner race: least film thickness over roughness; 0 without a film
    lambda_ratio_inner: NDArray[np.float32]
    #: Film parameter λ at the outer race: least film thickness over roughness; 0 without a film
    lambda_ratio_outer: NDArray[np.float32]
    #: Mean temperature of the film at the inner race less that of its surroundings, K
    film_temperature_rise_inner_k: NDArray[np.float32]
    #: Mean temperature of the film at the outer race less that of its surroundings, K
    film_temperature_rise_outer_k: NDArray[np.float32]


class SweepColumns:
    """Columns of sweeps; swept values have those of their paths beside them."""

    row: Any
    converged: Any
    residual: Any
    iterations: Any
    cage_speed_rpm: Any
    ring_displacement_x_m: Any
    ring_displacement_y_m: Any
    ring_displacement_z_m: Any
    ring_tilt_x_rad: Any
    ring_tilt_y_rad: Any
    ring_load_x_n: Any
    ring_load_y_n: Any
    ring_load_z_n: Any
    ring_moment_x_nm: Any
    ring_moment_y_nm: Any
    shaft_torque_nm: Any
    inner_speed_rad_s: Any
    outer_speed_rad_s: Any
    patch_error_estimate: Any
    orbital_speed_min_rad_s: Any
    orbital_speed_max_rad_s: Any
    power_loss_fluid_w: Any
    pocket_force_max_n: Any
    wear_rate_cage_m3_s: Any
    contact_angle_inner_min_deg: Any
    contact_angle_inner_max_deg: Any
    contact_angle_outer_min_deg: Any
    contact_angle_outer_max_deg: Any
    load_inner_min_n: Any
    load_inner_max_n: Any
    load_outer_min_n: Any
    load_outer_max_n: Any
    peak_pressure_inner_max_pa: Any
    peak_pressure_outer_max_pa: Any
    slide_to_roll_inner_max: Any
    slide_to_roll_outer_max: Any
    spin_ratio_inner_max_per_m: Any
    spin_ratio_outer_max_per_m: Any
    sliding_speed_inner_max_m_s: Any
    sliding_speed_outer_max_m_s: Any
    power_loss_inner_w: Any
    power_loss_outer_w: Any
    wear_rate_inner_m3_s: Any
    wear_rate_outer_m3_s: Any
    film_central_inner_min_m: Any
    film_central_outer_min_m: Any
    film_minimum_inner_min_m: Any
    film_minimum_outer_min_m: Any
    lambda_ratio_inner_min: Any
    lambda_ratio_outer_min: Any
    film_temperature_rise_inner_max_k: Any
    film_temperature_rise_outer_max_k: Any
    balls_in_contact: Any
    warnings: Any
    implausible: Any
    error: Any
