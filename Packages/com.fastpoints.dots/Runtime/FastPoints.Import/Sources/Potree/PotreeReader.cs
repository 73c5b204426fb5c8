using System;
using System.Collections.Generic;
using System.Threading;
using FastPoints.Reading;
using Unity.Mathematics;

namespace FastPoints.Sources
{
    // The octrees of PotreeConverter, 1.4 to 1.8 and 2.x. A hierarchy's claims are checked against the existing files: missing or
    // short ones are holes with warnings. Each byte of a hierarchy is used only once, so that loops end.
    internal abstract class PotreeReader : NodeReader
    {
        internal const int MaxLevels = 30; // Cells of deeper levels do not fit 32-bit coordinates; converters stop far above.
        internal const int MaxNodes = 1 << 21; // More than the largest clouds have: it bounds the memory of a hierarchy.
        internal const int MaxBlockPoints = 1 << 20; // Limit of a block that can be split.
        internal const int MaxNodePoints = 1 << 22; // Limit of a node that cannot be split.

        // In the columns of a node that cannot be cut: it bounds a slot, whatever a file claims.
        internal const int MaxNodeBytes = 1 << 27;
        const int MaxBlockBytes = 1 << 26; // In the records of a block that can be cut.

        private protected PotreeReader(SourceInfo info, BoundsGeo cube, double spacing) : base(info, cube, spacing) { }

        internal abstract PotreeLayout Layout { get; } // Null for nodes that are LAS or LAZ files.

        private protected sealed override int BytesPerPoint => HasCheapRanges ? Layout.RecordBytes : 0;

        // Grid steps from a block's corner to the cloud's.
        internal abstract int3 ShiftOf(int block);

        internal sealed override string NameOf(int level, int3 cell) => PotreeNames.NameOf(level, cell);

        private protected long PointsClaimed { get; set; } // According to the hierarchy, as far as it has been read.

        public override long BytesOfRange(BlockRange range)
        {
            var block = Block(range.Block);
            long points = HasCheapRanges ? range.Count : range.First + range.Count;
            return (long)(BytesOf(block) * (points / (double)Math.Max(1, block.Points)));
        }

        private protected UnreadPages Pages { get; } = new UnreadPages(MaxLevels + 1);

        // The reader, once it has read the first level of its tree.
        private protected static T WithFirstLevel<T>(T reader) where T : PotreeReader => Opened(reader, opened =>
        {
            using var steps = new CoroutineStack(opened.ReadHierarchyBelow(default, 1));
            while (steps.MoveNext())
                Thread.Yield();
        });

        public override IEnumerator<JobStep> IndexBlocks() => ReadHierarchyBelow(default, MaxLevels + 1);

        public override IEnumerator<JobStep> ReadHierarchyBelow(int4 node, int levels)
        {
            if (!Tree.IsHierarchyRead)
                yield return JobStep.Of(ReadPages(node, levels));
            if (!Tree.IsHierarchyRead)
                yield break;
            Info.PointsReadable = PointCount;
            if (Info.PointsClaimed == 0)
                Info.PointsClaimed = (ulong)PointsClaimed;
        }

        // Coroutine, which can be abandoned and begun again for another node: reads the parts of the hierarchy that the first
        // levels need for a node and what is below it. Steps take some milliseconds at most.
        private protected abstract IEnumerator<JobStep> ReadPages(int4 node, int levels);

        // bytes: of all its points in the file; bytesPerPoint: if fixed, so that a long node can be cut; otherwise 0.
        private protected void AddNode(int level, int3 cell, long points, long offset, long bytes, int bytesPerPoint) =>
            AddNode(new SourceNode { Level = level, Cell = cell }, points,
                bytesPerPoint > 0 ? Math.Min(MaxBlockPoints, MaxBlockBytes / bytesPerPoint) : points, offset, bytes,
                bytesPerPoint);

        private protected bool WarnIfFull(long offset)
        {
            if (Tree.NodeCount < MaxNodes)
                return false;
            Info.Warn(offset, "the hierarchy has more than " + NumberText.Of(MaxNodes) + " nodes: the others are left out");
            return true;
        }
    }

    // r, then a digit a level: 4 x + 2 y + z, each 0 for the lower half of the axis.
    internal static class PotreeNames
    {
        public static string NameOf(int level, int3 cell)
        {
            var name = new char[level + 1];
            name[0] = 'r';
            for (int i = 1; i <= level; i++)
                name[i] = (char)('0' + ChildOf(cell >> level - i));
            return new string(name);
        }

        public static bool TryParse(string name, int maxLevels, out int level, out int3 cell)
        {
            level = name.Length - 1;
            cell = default;
            if (level < 0 || level > maxLevels || name[0] != 'r')
                return false;
            for (int i = 1; i < name.Length; i++)
            {
                int child = name[i] - '0';
                if (child < 0 || child > 7)
                    return false;
                cell = Child(cell, child);
            }
            return true;
        }

        public static int3 Child(int3 cell, int child) => cell * 2 + new int3(child >> 2 & 1, child >> 1 & 1, child & 1);

        static int ChildOf(int3 cell) => (cell.x & 1) << 2 | (cell.y & 1) << 1 | cell.z & 1;
    }
}
