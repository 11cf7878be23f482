# What QGIS makes of the layers of a plan and of a run's project, as JSON.
#
#   qgis_viewer.py FORM.gpkg RUN_FOLDER
import json
import sys

from qgis.core import (QgsApplication, QgsDateTimeRange, QgsGeometry, QgsMapRendererParallelJob,
                       QgsMapSettings, QgsProject, QgsVectorLayer, QgsVectorLayerUtils)
from qgis.PyQt.QtCore import QDateTime, QSize, Qt


def drawn_sequences(form):
    """The Sequence that new features get in layers named as QGIS names them."""
    names = ['Route', 'Pause', 'EVA', 'Route']
    layers = {name: QgsVectorLayer(f'{form}|layername={name}', f'mission — {name}', 'ogr')
              for name in names}
    for layer in layers.values():
        QgsProject.instance().addMapLayer(layer)
    sequences = []
    for name in names:
        layer = layers[name]
        layer.startEditing()
        feature = QgsVectorLayerUtils.createFeature(layer)
        feature['RoverId'] = 'A'
        if name == 'Route':
            feature.setGeometry(QgsGeometry.fromWkt('LINESTRING(0 0,0.001 0)'))
        sequences.append(int(feature['Sequence']))
        layer.addFeature(feature)
        layer.commitChanges()
    tabs = [tab.name() for tab in layers['Route'].editFormConfig().tabs()]
    QgsProject.instance().clear()
    return sequences, tabs


def colours(project, time_range=None):
    """How many colours its map has."""
    settings = QgsMapSettings()
    layers = [node.layer() for node in project.layerTreeRoot().findLayers() if node.isVisible()]
    settings.setLayers(layers)
    settings.setDestinationCrs(project.crs())
    settings.setExtent(project.viewSettings().defaultViewExtent())
    settings.setOutputSize(QSize(600, 400))
    if time_range:
        settings.setIsTemporal(True)
        settings.setTemporalRange(time_range)
    job = QgsMapRendererParallelJob(settings)
    job.start()
    job.waitForFinished()
    image = job.renderedImage()
    return len({image.pixel(x, y) for x in range(0, 600, 2) for y in range(0, 400, 2)})


def main():
    form, run = sys.argv[1:]
    application = QgsApplication([], False)
    application.initQgis()
    sequences, tabs = drawn_sequences(form)
    project = QgsProject.instance()
    is_read = project.read(f'{run}/mission.qgz')
    time = project.timeSettings()
    print(json.dumps({
        'sequences': sequences,
        'tabs': tabs,
        'is_read': is_read,
        'layers': {layer.name(): {
            'is_valid': layer.isValid(),
            'crs': layer.crs().authid(),
            'is_temporal': bool(layer.temporalProperties()) and
            layer.temporalProperties().isActive(),
        } for layer in project.mapLayers().values()},
        'step_s': time.timeStep(),
        'begin': time.temporalRange().begin().toString(Qt.ISODate),
        'colours': colours(project),
    }))


main()
