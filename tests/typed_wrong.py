"""A user's script of which a type checker refuses each line below the scene, with the code behind it."""

# ruff: noqa: B018

import numpy as np

import planar_pushing as pp

slider = pp.Slider(rod_length=2.0, rod_angle=0.8)
effects = (pp.RingFriction(),)
scene = pp.Scene(slider=slider, contact=pp.Coulomb(2.0), effects=effects)
floats = np.linspace(0.0, 1.0, 3)

pp.Scene(slider=slider, contact=2, effects=effects)  # arg-type
pp.Scene(slider=slider, contact=pp.Coulomb, effects=effects)  # arg-type
pp.Scene(slider=slider, contact=pp.Coulomb(1.0), effects=(1.0,))  # arg-type
pp.Coulomb("0.5")  # arg-type
pp.Coulomb((0.1, 0.2))  # arg-type
pp.stable(scene, "up")  # arg-type
pp.stable(scene, (0.0, 1.0))  # arg-type
pp.stable(scene, (0.0, 1.0, 0.0)).nosuch  # attr-defined
pp.InfiniteFriction("both")  # arg-type
pp.solve(scene, "up")  # call-overload
pp.solve(scene, (0.1, 1.0))  # call-overload
pp.solve(scene, 1.0).force  # attr-defined
pp.solve(scene, 1.0)["STICK"]  # call-overload
pp.solve(scene, 1.0)[0].nosuch  # attr-defined
pp.solve(scene, floats).nosuch  # attr-defined
pp.limit_curve(scene, floats).nosuch  # attr-defined
pp.motion_angle(scene, 1.0).nosuch  # attr-defined
pp.motion_angle(scene, (0.1, 1.0))  # call-overload
pp.spin_ratio(scene)  # call-overload
pp.motion_centers(scene, 1.0, origin="center")  # call-overload
pp.motion_cone(scene).nosuch  # attr-defined
pp.friction_cone(scene).nosuch  # attr-defined
pp.can_pull(scene).nosuch  # attr-defined
pp.Pusher(velocity=(0.0, 1.0), shape="fingr")  # arg-type
pusher = pp.Pusher(velocity="up")  # arg-type
pp.simulate(scene, pusher=pusher, duration=1.0, method="rk4")  # arg-type
pp.simulate(scene, pusher=pusher, duration=1.0, on_ambiguity="stik")  # arg-type
pp.simulate_batch(scene, pusher, duration=1.0, on_ambiguity="stik")  # arg-type
