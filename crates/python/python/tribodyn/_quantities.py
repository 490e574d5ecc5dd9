"""Attributes of balls and solutions, by ``tools/quantities.py`` from the program's table of quantities."""

from __future__ import annotations

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
    spin_axial_rad_s: float
    #: Angular velocity relative to the orbiting frame, radial component, rad/s
    spin_radial_rad_s: float
    #: Angular velocity relative to the orbiting frame, tangential component, rad/s
    spin_tangential_rad_s: float
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
    #: Power that churning takes from the absolute spin, W; with traction only
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
    spin_axial_rad_s: NDArray[np.float64]
    #: Angular velocity relative to the orbiting frame, radial component, rad/s
    spin_radial_rad_s: NDArray[np.float64]
    #: Angular velocity relative to the orbiting frame, tangential component, rad/s
    spin_tangential_rad_s: NDArray[np.float64]
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
    #: Power that churning takes from the absolute spin, W; with traction only
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
