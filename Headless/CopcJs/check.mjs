// Reads a COPC file by copc.js: all pages, and the points of every node. Prints what it found as JSON.
import { Copc, Getter } from 'copc'

const get = Getter.file(process.argv[2])
const copc = await Copc.create(get)
const { cube, gpsTimeRange, rootHierarchyPage, spacing } = copc.info
const nodes = {}
const sums = {}
let pages = 0
let outside = 0
for (const left = [rootHierarchyPage]; left.length > 0; pages++) {
  const page = await Copc.loadHierarchyPage(get, left.pop())
  left.push(...Object.values(page.pages))
  Object.assign(nodes, page.nodes)
}
for (const [key, node] of Object.entries(nodes)) {
  if (node.pointCount === 0) continue
  const view = await Copc.loadPointDataView(get, copc, node)
  const [level, ...cell] = key.split('-').map(Number)
  const edge = (cube[3] - cube[0]) / 2 ** level
  for (const name of Object.keys(view.dimensions)) {
    const value = view.getter(name)
    const axis = ['X', 'Y', 'Z'].indexOf(name)
    const corner = axis < 0 ? 0 : cube[axis] + cell[axis] * edge
    let sum = 0
    for (let i = 0; i < view.pointCount; i++) {
      const at = value(i)
      sum += axis < 0 ? at : Math.round((at - copc.header.offset[axis]) / copc.header.scale[axis])
      if (axis >= 0 && !(at > corner && at < corner + edge)) outside++
    }
    sums[name] = (sums[name] ?? 0) + sum
  }
}
console.log(JSON.stringify({
  points: copc.header.pointCount,
  pointsOfNodes: Object.values(nodes).reduce((sum, node) => sum + node.pointCount, 0),
  pointFormat: copc.header.pointDataRecordFormat,
  nodes: Object.keys(nodes).length, pages, outside, spacing, gpsTimeRange, hasWkt: Boolean(copc.wkt), sums,
}))
