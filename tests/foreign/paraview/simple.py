"""Stands in for ParaView's module of this name, which Debian does not install beside VTK's: reads the series with VTK, answers what
paraview.py asks, and remembers the names of arrays it used. Anything it does not know is an error."""
import os
import xml.etree.ElementTree as xml

from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

used = []  # (source, "CELLS" or "POINTS", array, whether the source has it)
files, sources, shown = [], {}, []


class Source:
    def __init__(self, registrationName, Input=None, data=None, **settings):
        self.name, self.data = registrationName, data if data is not None else Input.data
        sources[registrationName] = self
        self.__dict__.update(settings)

    def __setattr__(self, key, value):
        self.__dict__[key] = value
        if key in ("Vectors", "Scalars"):
            use(self, *value)

    def UpdatePipeline(self, time):
        pass

    def GetDataInformation(self):
        return self.data

    @property
    def CellData(self):
        arrays = self.data.GetCellData()
        return {arrays.GetArrayName(i): i for i in range(arrays.GetNumberOfArrays())}


def use(source, kind, name, *component):
    arrays = source.data.GetCellData() if kind == "CELLS" else source.data.GetPointData()
    used.append((source.name, kind, name, bool(arrays.HasArray(name))))


class Display:
    def __init__(self, source):
        self.source = source

    def SetRepresentationType(self, kind):
        assert kind in ("Surface", "Surface With Edges")

    def RescaleTransferFunctionToDataRange(self, extend, force):
        pass

    def SetScalarBarVisibility(self, view, visible):
        pass


class Plain:
    AnimationTime = 0

    def UpdateAnimationUsingDataTimeSteps(self):
        pass

    def GoToLast(self):
        pass


def PVDReader(registrationName, FileName):
    files.append(FileName)
    last = list(xml.parse(FileName).getroot().iter("DataSet"))[-1].get("file")
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(os.path.join(os.path.dirname(FileName), last))
    reader.Update()
    return Source(registrationName, data=reader.GetOutput())


WarpByVector = Threshold = AnnotateTimeFilter = Source


def Show(source, view, representation=""):
    shown.append(source.name)
    return Display(source)


def ColorBy(display, array):
    use(display.source, *array)


def GetActiveViewOrCreate(kind):
    return Plain()


def GetAnimationScene():
    return Plain()


def GetColorTransferFunction(name):
    return Plain()


def Hide(source, view):
    shown.remove(source.name)


def SetActiveSource(source):
    pass


def ResetCamera(view):
    pass


def Render(view):
    pass
