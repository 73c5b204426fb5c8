using System;
using FastPoints.Store;
using Unity.Collections;

namespace FastPoints.Nodes
{
    /// <summary>The progress of a <see cref="WriteNodesJob"/> between two slices, and its working memory.</summary>
    internal struct WriteScratch : IDisposable
    {
        /// <summary>Where the next slice continues.</summary>
        public enum Stage
        {
            Start,
            SortPoints,
            Plan,
            Write,
            Done,
        }

        /// <summary>The progress of the job.</summary>
        public struct State
        {
            public Stage Stage;

            /// <summary>The next point or node, and its next plane.</summary>
            public int At;
            public int Plane;
            public int NodeCount;

            /// <summary>Of the current node: whether a point of it stands for others, and the next averaged column.</summary>
            public bool HasAverages;
            public int AveragedColumn;
        }

        public NativeReference<State> Progress;

        /// <summary>For each draft, the index of its first point in the order of drafts.</summary>
        public NativeList<int> FirstPointOfDraft;

        /// <summary>For each node of the file, its draft and its children.</summary>
        public NativeList<int> DraftOfNode;
        public NativeList<int> FirstChild;
        public NativeList<int> ChildCount;

        /// <summary>The table, indexed by node, and by node and plane.</summary>
        public NativeList<NodeRecord> Nodes;
        public NativeList<PlaneRange> Ranges;

        public WriteScratch(Allocator allocator)
        {
            Progress = new NativeReference<State>(allocator);
            FirstPointOfDraft = new NativeList<int>(64, allocator);
            DraftOfNode = new NativeList<int>(64, allocator);
            FirstChild = new NativeList<int>(64, allocator);
            ChildCount = new NativeList<int>(64, allocator);
            Nodes = new NativeList<NodeRecord>(64, allocator);
            Ranges = new NativeList<PlaneRange>(64, allocator);
        }

        public bool IsDone => Progress.Value.Stage == Stage.Done;

        public void Dispose()
        {
            if (!Progress.IsCreated)
                return;
            Progress.Dispose();
            FirstPointOfDraft.Dispose();
            DraftOfNode.Dispose();
            FirstChild.Dispose();
            ChildCount.Dispose();
            Nodes.Dispose();
            Ranges.Dispose();
        }
    }
}
