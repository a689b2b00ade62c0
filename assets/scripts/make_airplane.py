"""The aircraft: a high-winged propeller plane, 8.3 m long, wings of 10.8 m. Writes airplane.glb and its livery.

Body axes: forward -z, right +x, up +y, metres, origin at the centre of mass. Parts that move are nodes of
their own: a control surface turns about its node's x axis (positive: trailing edge down, or to the right for
the rudder), the propeller about its node's z axis.
"""

import argparse
import pathlib

import numpy as np

import airplane_livery as livery
import airplane_shape as shape
import glb
from glb import MeshBuilder, Node


FAR = "_far"  # ends the names of the parts that are drawn instead where a pixel covers more than 2 cm


def outside(suffix=""):
    """The aircraft without propeller and cockpit, in the detail of shape.detail."""
    aileron_right, (inner, outer) = shape.aileron()
    aileron_left = shape.mirror_wing(aileron_right)
    elevator_mesh, elevator_hinge = shape.elevator()
    (y0, z0), (y1, z1) = shape.RUDDER_Z
    up = np.array([0, 1.0, 0])
    tail = MeshBuilder()
    tail.add(shape.tailplane())
    tail.add(shape.fin_part("front", shape.fin_heights(.30)))
    flip = np.array([-1.0, 1, 1])
    parts = [
        Node("fuselage", shape.fuselage(), "livery"),
        Node("wing", shape.wing(), "livery"),
        Node("struts", shape.struts(), "livery"),
        Node("tail", tail, "livery"),
        Node("gear", shape.gear(), "livery"),
        Node("aileron_left", aileron_left, "livery", glb.frame_matrix(inner * flip, (inner - outer) * flip, up)),
        Node("aileron_right", aileron_right, "livery", glb.frame_matrix(inner, outer - inner, up)),
        Node("elevator", elevator_mesh, "livery", glb.translation_matrix([0, *elevator_hinge[1:]])),
        Node("rudder", shape.fin_part("rear", shape.fin_heights(.16)), "livery",
             glb.frame_matrix([0, y0, z0], [0, y1 - y0, z1 - z0], [-1.0, 0, 0])),
        Node("spinner", shape.spinner(), "livery", glb.translation_matrix(shape.PROPELLER_CENTRE)),
    ]
    for part in parts:
        part.name += suffix
    return parts


def build(folder):
    folder = pathlib.Path(folder)
    nodes = outside()
    nodes += [
        Node("propeller", shape.propeller(), "livery", glb.translation_matrix(shape.PROPELLER_CENTRE)),
        Node("propeller_disc", shape.propeller_disc(), "livery", glb.translation_matrix(shape.PROPELLER_CENTRE)),
        Node("cockpit", shape.cockpit(), "livery"),
    ]
    shape.detail = shape.COARSE
    nodes += outside(FAR)
    shape.detail = shape.FINE
    glb.write_glb(folder / "airplane.glb", "airplane", nodes,
                  {"livery": ("airplane_diffuse.png", "airplane_specular.png")})
    colour, specular = livery.livery()
    glb.write_png(folder / "airplane_diffuse.png", colour)
    glb.write_png(folder / "airplane_specular.png", specular)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", nargs="?", default=pathlib.Path(__file__).parents[1] / "models")
    build(parser.parse_args().folder)
