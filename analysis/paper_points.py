"""The paper's walls with the fluid's viscosity in a figure against G. The paper gives two values of G for a row, one in its
table and half of that in its text: both are drawn."""

from campaign_data import read_reference

READINGS = (("G_table", "0.35", "table 1"), ("G_text", "0.65", "text"))


def draw_paper(panel, *drawn):
    """Each of `drawn`: a quantity of the table, its marker, and how a label begins."""
    paper = read_reference("rosti_brandt_2017_tables.csv")
    usable = paper["viscosity_ratio"] == 1
    for column, shade, source in READINGS:
        for quantity, marker, words in drawn:
            panel.plot(paper[column][usable], paper[quantity][usable], f"{marker}:", color=shade, linewidth=0.7,
                       label=f"{words}, G as in its {source}")
