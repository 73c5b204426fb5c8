using System;
using FastPoints.Points;
using FastPoints.Store;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Streaming
{
    /// <summary>
    /// Anything with a hierarchy and nodes that can be read: what streaming needs to know of a cloud. A hierarchy comes in pages,
    /// the first of them with the source; a node's planes are pieces of its page's file, packed in blocks, and are shown as
    /// they lie there.
    /// </summary>
    public abstract class NodeSource : IDisposable
    {
        /// <summary>For messages.</summary>
        public abstract string Path { get; }
        public abstract CloudGrid Grid { get; }
        public abstract GridCube Root { get; }
        public abstract StoreLayout Layout { get; }

        /// <summary>The planes that are streamed, as indices in <see cref="Layout"/>, rising; position is the first.</summary>
        public abstract NativeArray<int> Planes { get; }

        /// <summary>By plane of <see cref="Layout"/>; the position's as it is in nodes that are not wide.</summary>
        public abstract NativeArray<PlaneShape> Shapes { get; }

        public abstract int PageCount { get; }

        /// <summary>The boxes of all pages, and the nodes of the first. Whoever takes the pages frees them.</summary>
        /// <param name="pages">Room for <see cref="PageCount"/>.</param>
        public abstract unsafe void CreatePages(HierarchyPage* pages);

        /// <summary>The file that the planes of a page's nodes lie in.</summary>
        public abstract string PathOf(int page);

        /// <summary>What is read to build a page.</summary>
        public abstract FilePiece TableOf(int page);

        /// <summary>Checks what was read and makes the page of it.</summary>
        public abstract JobHandle ScheduleBuild(int page, NativeArray<byte> table, NativeReference<HierarchyPage> built,
            NativeReference<TableProblem> problem);

        /// <summary>What <see cref="ScheduleBuild"/> found wrong, in words.</summary>
        public abstract string Describe(int page, NativeArray<byte> table, TableProblem problem);

        public abstract void Dispose();
    }
}
