using System;
using System.Collections.Generic;
using FastPoints.Base;
using FastPoints.Points;
using FastPoints.Store;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Streaming
{
    /// <summary>
    /// Anything with a hierarchy and nodes that can be read: what streaming needs to know of a cloud. A hierarchy comes in pages,
    /// the first of them with the source. A node's planes are pieces of its page's file, packed in blocks, and are shown as
    /// they lie there; or, where they do not lie so (<see cref="MakesNodes"/>), a <see cref="NodeMaker"/> makes them.
    /// </summary>
    public abstract class NodeSource : IDisposable
    {
        /// <summary>For messages.</summary>
        public abstract string Path { get; }
        public abstract CloudCrs Crs { get; }

        /// <summary>Whether all points of the cloud are in it: not so of a preview, and of a build in progress.</summary>
        public abstract bool HasAllPoints { get; }

        public abstract CloudGrid Grid { get; }
        public abstract GridCube Root { get; }
        public abstract NodeCubes Cubes { get; }
        public abstract StoreLayout Layout { get; }

        /// <summary>The planes that are streamed, as indices in <see cref="Layout"/>, rising; position is the first.</summary>
        public abstract NativeArray<int> Planes { get; }

        /// <summary>By plane of <see cref="Layout"/>; the position's as it is in nodes that are not wide.</summary>
        public abstract NativeArray<PlaneShape> Shapes { get; }

        /// <summary>Pages that are known. Where nodes are made, building one may make more known, behind the others.</summary>
        public abstract int PageCount { get; }

        /// <summary>Whether nodes are made when they are wanted, and pages of what the source has read of its hierarchy: then
        /// <see cref="PlaneRange.LengthBytes"/> of a node is a bound until it was made once, and what is said of files here
        /// and of tables means nothing.</summary>
        public virtual bool MakesNodes => false;

        /// <summary>The boxes of all pages, and the nodes of the first. Whoever takes the pages frees them.</summary>
        /// <param name="pages">Room for <see cref="PageCount"/>.</param>
        public abstract unsafe void CreatePages(HierarchyPage* pages);

        /// <summary>The file that the planes of a page's nodes lie in.</summary>
        public abstract string PathOf(int page);

        /// <summary>What is read to build a page.</summary>
        internal abstract FilePiece TableOf(int page);

        /// <summary>Checks what was read and makes the page of it.</summary>
        public abstract JobHandle ScheduleBuild(int page, NativeArray<byte> table, NativeReference<HierarchyPage> built,
            NativeReference<TableProblem> problem);

        /// <summary>What <see cref="ScheduleBuild"/> found wrong, in words.</summary>
        public abstract string Describe(int page, NativeArray<byte> table, TableProblem problem);

        /// <summary>Where nodes are made: whether a page can be built now. If not, being asked makes the source read what is
        /// missing.</summary>
        public virtual bool CanBuild(int page) => true;

        /// <summary>Where nodes are made: takes note of a page that was built. Pages that hang on it are numbered.</summary>
        public virtual void Adopt(int page, in HierarchyPage built)
        {
        }

        /// <summary>Where nodes are made: the box of a page that was not built yet.</summary>
        public virtual HierarchyPage EmptyPage(int page) => default;

        /// <summary>Once a frame. Waits for nothing.</summary>
        /// <returns>What went wrong, or null.</returns>
        public virtual PointCloudException Update() => null;

        /// <summary>What <see cref="Update"/> has under way.</summary>
        public virtual JobHandle Reading => default;

        /// <summary>Where nodes are made: a maker that is idle, until it is given back. Null while enough are at work.</summary>
        /// <param name="points">Of the node that it is wanted for.</param>
        public virtual NodeMaker TakeMaker(int points) => null;

        public virtual void GiveMaker(NodeMaker maker)
        {
        }

        /// <summary>Where nodes are made: a maker of every plane of <see cref="Layout"/>, whatever is streamed. The caller's;
        /// goes before the source.</summary>
        public virtual NodeMaker CreateWholeMaker() => throw new NotSupportedException();

        /// <summary>Work for a pump that opens the same cloud once more, to look at single points: with positions and classes,
        /// and all other planes of attributes where they lie in files or <see cref="CreateWholeMaker"/> makes them. Opens files
        /// on another thread. Comes to nothing where the cloud was in memory alone, and its source is disposed.</summary>
        /// <param name="opened">Takes the source over.</param>
        /// <exception cref="PointCloudException">The cloud is not there any more, or damaged.</exception>
        public abstract IEnumerator<Work> OpenForPicking(Action<NodeSource> opened);

        public abstract void Dispose();
    }

    /// <summary>Consecutive bytes of a file.</summary>
    internal struct FilePiece
    {
        public string Path;
        public long OffsetBytes;
        public long LengthBytes;
    }
}
