# A view of this run for ParaView 5.10 or later: File > Load State, or paraview --script=paraview.py.
import os

from paraview.simple import *

FOLDER = r"@FOLDER@"  # where the run wrote its results
FIELD = "@FIELD@"  # output.picture.field of the scene
SCALE = @SCALE@  # magnification of displacements

here = globals().get("__file__")  # results that were moved lie beside this file
if here and os.path.exists(os.path.join(os.path.dirname(os.path.abspath(here)), "blocks.pvd")):
    FOLDER = os.path.dirname(os.path.abspath(here))


def series(name):
    path = os.path.join(FOLDER, name + ".pvd")
    return PVDReader(registrationName=name, FileName=path) if os.path.exists(path) else None


def last_time(*readers):
    scene = GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    scene.GoToLast()
    for reader in readers:
        if reader:
            reader.UpdatePipeline(scene.AnimationTime)


def colour(display, view, name, length=False):
    """By an array of the cells; a vector by its length. The range is that of the time shown."""
    ColorBy(display, ("CELLS", name, "Magnitude") if length else ("CELLS", name))
    display.RescaleTransferFunctionToDataRange(False, True)
    display.SetScalarBarVisibility(view, True)


def name_values(name, names, colours):
    """Whole numbers as names in the colour bar."""
    table = GetColorTransferFunction(name)
    table.InterpretValuesAsCategories = 1
    table.Annotations = [text for number, one in enumerate(names) for text in (str(number), one)]
    table.IndexedColors = [part for one in colours for part in one]


def show_blocks(blocks, view):
    shown = blocks
    if SCALE > 1:  # points lie where they are now: (SCALE - 1) times the displacement more
        shown = WarpByVector(registrationName="magnified", Input=blocks)
        shown.Vectors = ["POINTS", "displacement"]
        shown.ScaleFactor = SCALE - 1
    display = Show(shown, view, "GeometryRepresentation")
    display.SetRepresentationType("Surface With Edges")
    display.EdgeColor = [0.35, 0.35, 0.35]
    vectors = {"speed": "velocity", "velocity": "velocity", "displacement": "displacement"}
    known = list(blocks.CellData.keys())
    field = vectors.get(FIELD, FIELD)
    colour(display, view, field if field in known else "displacement", length=FIELD in vectors or field not in known)


def cells(source):
    return source.GetDataInformation().GetNumberOfCells()


def show_cracks(cracks, view):
    display = Show(cracks, view, "GeometryRepresentation")
    display.LineWidth = 3
    if cells(cracks) == 0:  # by the last time none has opened
        return
    ColorBy(display, ("CELLS", "mode"))
    name_values("mode", ["real joint", "tension", "shear"], [(0.4, 0.4, 0.4), (0.8, 0.1, 0.1), (0.1, 0.2, 0.8)])
    display.SetScalarBarVisibility(view, True)
    if "gas_pressure" in cracks.CellData.keys():
        show_gas(cracks, view)


def show_gas(cracks, view):
    gas = Threshold(registrationName="gas", Input=cracks)  # joints that the gas has entered
    gas.Scalars = ["CELLS", "gas"]
    gas.LowerThreshold, gas.UpperThreshold = 1e-9, 1
    gas.ThresholdMethod = "Between"
    gas.UpdatePipeline(GetAnimationScene().AnimationTime)
    display = Show(gas, view, "UnstructuredGridRepresentation")
    display.LineWidth = 6
    if cells(gas) > 0:
        colour(display, view, "gas_pressure")


def show_joints(joints, view):
    """There to be switched on: bonds and contacts by their state."""
    display = Show(joints, view, "GeometryRepresentation")
    ColorBy(display, ("CELLS", "state"))
    grey, red, white, green, yellow = (0.6, 0.6, 0.6), (0.8, 0.1, 0.1), (1, 1, 1), (0.1, 0.6, 0.2), (0.9, 0.7, 0.1)
    name_values("state", ["intact", "failed", "open", "stick", "slip"], [grey, red, white, green, yellow])
    Hide(joints, view)


view = GetActiveViewOrCreate("RenderView")
view.InteractionMode = "2D"
view.OrientationAxesVisibility = 0
blocks, joints, cracks = series("blocks"), series("joints"), series("cracks")
if blocks is None:
    raise RuntimeError("no blocks.pvd beside this file, nor in " + FOLDER)
last_time(blocks, joints, cracks)
show_blocks(blocks, view)
if cracks:
    show_cracks(cracks, view)
if joints:
    show_joints(joints, view)
Show(AnnotateTimeFilter(registrationName="time", Input=blocks, Format="t = {time:g} s"), view)
SetActiveSource(blocks)
ResetCamera(view)
Render(view)
