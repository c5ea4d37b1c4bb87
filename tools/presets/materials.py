# SPDX-License-Identifier: Apache-2.0
"""Which spectrum is which metal preset, and the indices of the dielectric presets."""

MCPEAK = "McPeak et al. 2015, doi:10.1021/ph5004237"
NOBLE = "Johnson and Christy 1972, doi:10.1103/PhysRevB.6.4370"
JOHNSON = "Johnson and Christy 1974, doi:10.1103/PhysRevB.9.5056"
WERNER = "Werner et al. 2009 (REELS), doi:10.1063/1.3243762"
INAGAKI = "Inagaki et al. 1981, doi:10.1103/PhysRevB.23.5246"

# name, spectrum file, source. Reasons for the choice of files: docs/presets.md.
METALS = [
    ("gold", "Au_Johnson.yml", "Au: " + NOBLE),
    ("silver", "Ag_Johnson.yml", "Ag: " + NOBLE),
    ("copper", "Cu_Johnson.yml", "Cu: " + NOBLE),
    ("aluminium", "Al_McPeak.yml", "Al: " + MCPEAK),
    ("aluminum", "Al_McPeak.yml", "Al: " + MCPEAK),
    ("chromium", "Cr_Johnson.yml", "Cr: " + JOHNSON),
    ("iron", "Fe_Johnson.yml", "Fe: " + JOHNSON),
    ("nickel", "Ni_Johnson.yml", "Ni: " + JOHNSON),
    ("cobalt", "Co_Johnson.yml", "Co: " + JOHNSON),
    ("palladium", "Pd_Johnson.yml", "Pd: " + JOHNSON),
    ("titanium", "Ti_Johnson.yml", "Ti: " + JOHNSON),
    ("vanadium", "V_Johnson.yml", "V: " + JOHNSON),
    ("platinum", "Pt_Werner.yml", "Pt: " + WERNER),
    ("molybdenum", "Mo_Werner.yml", "Mo: " + WERNER),
    ("tantalum", "Ta_Werner.yml", "Ta: " + WERNER),
    ("tungsten", "W_Werner.yml", "W: " + WERNER),
    ("zinc", "Zn_Werner.yml", "Zn: " + WERNER),
    ("mercury", "Hg_Inagaki.yml", "Hg: " + INAGAKI),
]

# Spectra of the same metals that no preset uses: the manual shows how far apart sources are.
ALTERNATIVES = [
    ("gold", "Au_McPeak.yml", "McPeak et al. 2015"),
    ("silver", "Ag_McPeak.yml", "McPeak et al. 2015"),
    ("copper", "Cu_McPeak.yml", "McPeak et al. 2015"),
    ("aluminium", "Al_Rakic.yml", "Rakic 1995"),
]

# name, index against air, source. n_D: sodium D line, 589.3 nm; n_d: helium d line, 587.6 nm, the
# line of glass catalogues. The two differ by less than 3e-4 in every row.
DIELECTRICS = [
    ("water", "1.333", "n_D at 20 C: Daimon and Masumura 2007, doi:10.1364/AO.46.003811"),
    ("ice", "1.31", "n_D: Warren and Brandt 2008, doi:10.1029/2007JD009744"),
    ("glass", "1.5168", "n_d of Schott N-BK7, data sheet"),
    ("flint_glass", "1.7847", "n_d of Schott SF11, data sheet"),
    ("fused_silica", "1.4585", "n_d: Malitson 1965, doi:10.1364/JOSA.55.001205"),
    ("fused_quartz", "1.4585", "n_d, as fused_silica: Malitson 1965, doi:10.1364/JOSA.55.001205"),
    ("acrylic", "1.49", "n_d of PMMA: Sultanova et al. 2009, doi:10.12693/APhysPolA.116.585"),
    ("polycarbonate", "1.585", "n_d: Sultanova et al. 2009, doi:10.12693/APhysPolA.116.585"),
    ("polystyrene", "1.592", "n_d: Sultanova et al. 2009, doi:10.12693/APhysPolA.116.585"),
    ("fluorite", "1.434", "n_D of CaF2: Malitson 1963, doi:10.1364/AO.2.001103"),
    ("salt", "1.544", "n_D of NaCl: Li 1976, doi:10.1063/1.555536"),
    ("quartz", "1.544", "n_D, ordinary ray: Ghosh 1999, doi:10.1016/S0030-4018(99)00091-7"),
    ("sapphire", "1.77", "n_D, ordinary ray: Malitson and Dodge 1972, J. Opt. Soc. Am. 62, 1405"),
    ("cubic_zirconia", "2.158", "n_D: Wood and Nassau 1982, doi:10.1364/AO.21.002978"),
    ("diamond", "2.417", "n_D: Peter 1923, doi:10.1007/BF01330487"),
]
