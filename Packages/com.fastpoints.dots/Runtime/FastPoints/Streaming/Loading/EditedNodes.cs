using System;
using System.Collections.Generic;
using FastPoints.Store;
using Unity.Collections;

namespace FastPoints.Streaming
{
    // A node that edits may reach, as it is stored.
    internal struct EditedNode : IEquatable<EditedNode>
    {
        public int Number;
        public int Page;
        public Grid3 Corner;
        public bool IsWide;
        public int BlockCount;

        public int MaxPoints => BlockCount * PlaneShape.MaxPointsPerBlock;

        public bool Equals(EditedNode other) => Number == other.Number;

        public override int GetHashCode() => Number;
    }

    // The nodes of a cloud's folder that its edits may reach, of the pages that were registered. In a page their ranges say no
    // more where a plane lies, but which of these nodes it is, and how long what is left of the plane can be. Main thread.
    internal sealed class EditedNodes
    {
        const int NotEdited = -1;
        const int Empty = -2; // Reached, though without planes of its own.

        const int MaxTries = 4096; // Of prisms at nodes of a page: some ms. Other nodes are made anew, changed or not.

        readonly CloudFolder m_folder;
        readonly bool[] m_isChanged; // By Planes.
        readonly List<EditedNode> m_nodes = new List<EditedNode>();
        readonly List<PlaneRange> m_ranges = new List<PlaneRange>(); // By node and Planes.
        readonly List<int[]> m_numbers = new List<int[]>(); // By page and node.

        public EditedNodes(EditPlan plan, CloudFolder folder, NativeArray<int> streamed, bool mayLackNormals = false)
        {
            (Plan, m_folder, StreamedPlanes, MayLackNormals) = (plan, folder, streamed.Length, mayLackNormals);
            foreach (int plane in streamed)
                Planes.Add(plane);
            for (int p = 1; p < Layout.Planes.Count; p++)
                if (Layout.Planes[p].IsSource && !Planes.Contains(p) && IsNamed(plan.Schema, p))
                    Planes.Add(p);
            var changed = plan.Changed;
            m_isChanged = Planes.ConvertAll(p => p != StoreLayout.PositionPlane && IsNamed(changed, p)).ToArray();
        }

        public EditPlan Plan { get; }
        public StoreLayout Layout => m_folder.Layout;

        // In the layout: those that are streamed, then those that operations read besides.
        public List<int> Planes { get; } = new List<int>();
        public int StreamedPlanes { get; }
        public bool MayLackNormals { get; } // Those that cannot be read are unknown.

        public bool Has(int page, int node) =>
            page < m_numbers.Count && m_numbers[page] != null && m_numbers[page][node] >= 0;

        public EditedNode this[int number] => m_nodes[number];

        public PlaneRange RangeOf(in EditedNode node, int plane) => m_ranges[node.Number * Planes.Count + plane];

        // Null if it is shown as stored.
        public EditedNode? Find(int page, int node, in PageView table)
        {
            AddPage(page, table);
            return Has(page, node) ? m_nodes[m_numbers[page][node]] : (EditedNode?)null;
        }

        public string PathOf(in EditedNode node, bool isComputed) =>
            isComputed ? m_folder.PathOfComputed(node.Page) : m_folder.PlanesPathOf(node.Page);

        // A page that was built from a table; perhaps not for the first time.
        public unsafe void Register(int page, in HierarchyPage built, in PageView table)
        {
            AddPage(page, table);
            var numbers = m_numbers[page];
            for (int n = 0; n < numbers.Length; n++)
                for (int p = 0; p < StreamedPlanes && numbers[n] >= 0; p++)
                    built.Planes[n * StreamedPlanes + p] = new PlaneRange
                    {
                        OffsetBytes = numbers[n],
                        LengthBytes = MaxBytesOf(m_nodes[numbers[n]], p, built.Nodes[n].PointCount),
                    };
        }

        unsafe void AddPage(int page, in PageView table)
        {
            while (m_numbers.Count <= page)
                m_numbers.Add(null);
            if (m_numbers[page] != null)
                return;
            var numbers = m_numbers[page] = new int[table.NodeCount];
            for (int n = 0, tries = MaxTries; n < numbers.Length; n++)
            {
                var record = table.Nodes[n];
                // What reaches a node reaches its parent, which comes before it.
                bool isReached = (record.Parent < 0 || numbers[record.Parent] != NotEdited) &&
                    Plan.Reaches.Any(EditShape.Of(record.Cube), ref tries);
                numbers[n] = !isReached ? NotEdited : record.PlaneBlocks == 0 ? Empty : m_nodes.Count;
                if (numbers[n] < 0)
                    continue;
                for (int p = 0; p < Planes.Count; p++)
                    m_ranges.Add(table.RangeOf(n, Planes[p]));
                m_nodes.Add(new EditedNode
                {
                    Number = numbers[n],
                    Page = page,
                    Corner = record.Corner,
                    IsWide = record.IsWide,
                    BlockCount = record.PlaneBlocks,
                });
            }
        }

        // Fewer points of a block never take more; other values may.
        public long MaxBytesOf(in EditedNode node, int plane, int points)
        {
            if (!IsChanged(plane))
                return RangeOf(node, plane).LengthBytes;
            var of = Layout.Planes[Planes[plane]];
            long words = (long)node.BlockCount * (of.Shape.DescriptorWords + of.ColumnCount);
            for (int c = of.FirstColumn; c < of.FirstColumn + of.ColumnCount; c++)
                words += ((long)points * 8 * Layout.Columns[c].Type.SizeOf() + 31) / 32;
            return PlaneShape.LengthBytes(words);
        }

        // Among Planes.
        public bool IsChanged(int plane) => m_isChanged[plane];

        bool IsNamed(PointSchema schema, int plane)
        {
            var of = Layout.Planes[plane];
            for (int c = of.FirstColumn; c < of.FirstColumn + of.ColumnCount; c++)
                if (of.IsSource && schema.Has(Layout.NameOfColumn(of, c)))
                    return true;
            return false;
        }
    }
}
