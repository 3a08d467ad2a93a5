"""The scenes of the interoperability tests, as text."""

# A bar that vibrates along its axis, started in its first mode: 160 particles, about a thousand steps for two
# units of time, which are five periods.
VIBRATING_BAR = """
name: "vibrating-bar"
units: "m, s, kg"
constants { name: "L" value: "1" }
# The first mode of a slender plate that is fixed at one end; the edges along it are free.
constants { name: "omega" value: "pi/(2*L)*sqrt(100/(1 - 0.25^2)/1)" }
domain { dimension: PLANE_STRAIN lower { x: 0 y: 0 } upper { x: 1.5 y: 0.5 } cell_size: 0.05 }
materials { name: "steel" density: 1 linear_elastic { youngs_modulus: 100 poissons_ratio: 0.25 } }
bodies {
  name: "bar"
  material: "steel"
  geometry { box { lower { x: 0 y: 0.2 } upper { x: 1 y: 0.3 } } }
  initial_velocity { x: "0.1*sin(pi*x/(2*L))" }
}
boundaries {
  name: "wall"
  nodes { box { lower { x: 0 y: 0 } upper { x: 0 y: 0.5 } } }
  fixed { axes: X }
}
analysis { end_time: %(end_time)s }
outputs {
  samples: %(samples)s
  snapshots: 100
  probes { name: "tip" nearest { x: 1 y: 0.25 } fields: [DISPLACEMENT, VELOCITY] }
  probes { name: "whole" mean { box { lower { x: 0 y: 0 } upper { x: 1.5 y: 0.5 } } } fields: STRESS }
  probes { name: "reach" largest {} fields: [POSITION, VON_MISES_STRESS] }
}
measures { name: "last_tip_displacement" quantity: "tip.displacement.x" final {} }
measures { name: "largest_tip_displacement" quantity: "tip.displacement.x" extreme {} exact: "0.1/omega" tolerance: 0.1 }
"""

# Each mistake is alone: none of the others follows from it.
TEN_MISTAKES = """
name: "ten mistakes"
domain { dimension: PLANE_STRESS lower { x: 0 y: 0 } upper { x: 2 y: 1 } cell_size: 0.1 thickness: -1 }
materials { name: "steel" density: -7 linear_elastic { youngs_modulus: 100 poissons_ratio: 0.75 } }
bodies {
  name: "bar"
  material: "steal"
  geometry { box { lower { x: 0.5 y: 0.2 } upper { x: 1.5 y: 0.4 } } }
  particles_per_cell_side: 99
}
boundaries { name: "wall" nodes { box { lower { x: 0 y: 0 } upper { x: 0 y: 1 } } } }
analysis { end_time: 1 damping: -2 }
numerics { scheme: "MUSLE" flip_fraction: 1.5 }
outputs { samples: 0 }
"""

# The paths of the mistakes, as a reader of the schema would write them.
TEN_PATHS = {
    "name",
    "domain.thickness",
    "materials[0].density",
    "materials[0].linear_elastic.poissons_ratio",
    "bodies[0].material",
    "bodies[0].particles_per_cell_side",
    "boundaries[0]",
    "analysis.damping",
    "numerics.scheme",
    "numerics.flip_fraction",
    "outputs.samples",
}
