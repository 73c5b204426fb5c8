using System;
using System.Collections.Generic;
using FastPoints.Store;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Streaming
{
    /// <summary>Anything with a hierarchy and nodes that can be read: what streaming needs to know of a cloud. A hierarchy comes
    /// in pages, the first one with the source itself. A node's planes are pieces of its page's file, packed in blocks, and are
    /// shown as they lie there. If they are not stored like that (<see cref="TranscodesNodes"/>), a <see cref="NodeTranscoder"/>
    /// makes them.</summary>
    public abstract class NodeSource : IDisposable
    {
        /// <summary>The path for messages.</summary>
        public abstract string Path { get; }
        public abstract CloudCrs Crs { get; }

        /// <summary>Whether it has all points of the cloud, unlike a preview or a build in progress.</summary>
        public abstract bool HasAllPoints { get; }

        public abstract CloudGrid Grid { get; }
        public abstract GridCube Root { get; }
        public abstract NodeCubes Cubes { get; }
        public abstract StoreLayout Layout { get; }

        /// <summary>The streamed planes as rising indices in <see cref="Layout"/>; position is the first.</summary>
        public abstract NativeArray<int> Planes { get; }

        /// <summary>One for each plane of <see cref="Layout"/>; the position's is that of nodes that are not wide.</summary>
        public abstract NativeArray<PlaneShape> Shapes { get; }

        /// <summary>Registering a page may discover more, after the others.</summary>
        public abstract int PageCount { get; }

        /// <summary>Whether nodes are transcoded on demand, from pages of the part of the hierarchy that the source has read so
        /// far. Then <see cref="PlaneRange.LengthBytes"/> of a node is an upper bound until it was made once, and the members
        /// about files and tables have no meaning.</summary>
        public virtual bool TranscodesNodes => false;

        // Whether it shows the same nodes as another, so that the same of them are chosen.
        internal virtual bool HasNodesOf(NodeSource other) => false;

        // Of one node: where some of what lies in files was edited.
        internal virtual bool Transcodes(int page, int node) => TranscodesNodes;

        /// <summary>Creates the boxes of all pages and the nodes of the first one. The caller frees the pages.</summary>
        public abstract unsafe void CreatePages(HierarchyPage* pages);

        internal virtual bool KeepsFilesOpen => false;

        /// <summary>The file that holds the planes of a page's nodes.</summary>
        public abstract string PlanesPathOf(int page);

        // Whether a streamed plane was computed later: it lies in another file.
        internal virtual bool IsComputed(int plane) => false;

        internal virtual string PathOfComputed(int page) => null;

        internal virtual RemoteFile RemoteOfComputed(int page) => null;

        internal abstract FilePiece TableOf(int page);

        // The bytes of a page, if they are in memory.
        internal virtual bool TryCopyTable(int page, NativeArray<byte> to) => false;

        /// <summary>Checks the bytes read and builds a page from them.</summary>
        public abstract JobHandle ScheduleBuild(int page, NativeArray<byte> table, NativeReference<HierarchyPage> built,
            NativeReference<TableProblem> problem);

        /// <summary>Describes the problem that <see cref="ScheduleBuild"/> found.</summary>
        public abstract string Describe(int page, NativeArray<byte> table, TableProblem problem);

        // Whether a plane was found to be as written before, so that its hash need not be checked again. Main thread.
        internal virtual bool IsVerified(int page, int node, int plane) => false;

        internal virtual void SetVerified(int page, int node, int plane) { }

        // What was read of a page's file was wrong: it is checked, or fetched, again.
        internal virtual void Invalidate(int page) { }

        // The file of the planes of a page's nodes if it is on a web server, or null; and that of the page itself.
        internal virtual RemoteFile PlanesRemoteOf(int page) => null;

        internal virtual RemoteFile RemoteOfTable(int page) => null;
        internal virtual double RoundTrip => 0; // Seconds until a web server's answer begins; 0 for files.

        // A web server did not give what was wanted: the cloud may be another by now.
        internal virtual void MarkStale() { }

        /// <summary>For sources that transcode: if a page cannot be built now, the source reads what is missing.</summary>
        public virtual bool TryPrepareBuild(int page) => true;

        /// <summary>Registers a page that was built, and numbers the pages attached to it.</summary>
        /// <param name="table">What it was built from.</param>
        public virtual void RegisterPage(int page, in HierarchyPage built, NativeArray<byte> table) { }

        /// <summary>The box of a page that was not built yet.</summary>
        public virtual HierarchyPage EmptyPage(int page) => default;

        /// <summary>Called once a frame; it never waits. Returns the failure, or null.</summary>
        public virtual PointCloudException Update() => null;

        internal virtual bool IsReading => false;

        /// <summary>The handle of what <see cref="Update"/> has in flight.</summary>
        public virtual JobHandle Reading => default;

        /// <summary>For sources that transcode: an idle transcoder for this many points. Null while enough are busy.</summary>
        public virtual NodeTranscoder TryRentTranscoder(int points) => null;

        public virtual void ReturnTranscoder(NodeTranscoder transcoder) { }

        /// <summary>For sources that transcode: a transcoder of every plane, to be disposed before the source.</summary>
        public virtual NodeTranscoder CreateFullTranscoder() => throw new NotSupportedException();

        /// <summary>Coroutine: opens the same cloud once more, on another thread, to examine single points: with positions and
        /// classes, and all other planes if they lie in files or <see cref="CreateFullTranscoder"/> makes them. The receiver
        /// owns the source; there is none if the cloud was in memory alone and is disposed. Throws if it is gone or
        /// damaged.</summary>
        public abstract IEnumerator<JobStep> OpenForPicking(Action<NodeSource> opened);

        public abstract void Dispose();
    }
}
