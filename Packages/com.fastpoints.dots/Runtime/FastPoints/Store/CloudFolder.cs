using System;
using System.Collections.Generic;
using System.IO;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Store
{
    /// <summary>An opened cloud: its manifest and the first page of its hierarchy. The other pages are loaded on request, and
    /// numbered as those that link to them are. Everything is checked before it is used.</summary>
    public sealed class CloudFolder : IDisposable
    {
        const int MaxPagesInFlight = 32; // What is begun for callers that load page by page.

        // The uppermost pages end the hierarchy: of a web server they come with the root's, in one request.
        internal static int TailBytes = 1 << 18;

        const int Unknown = -1;

        readonly List<Page> m_pages = new List<Page>();
        readonly List<Container> m_containers = new List<Container>();
        readonly Dictionary<string, int> m_containerOfPath = new Dictionary<string, int>();
        readonly Dictionary<int, RemoteRead> m_fetched = new Dictionary<int, RemoteRead>(); // By page.
        readonly bool m_isRemote;
        NativeArray<byte> m_tail; // The end of the hierarchy's file, if it is on a web server.

        struct Page
        {
            public PageLink Link;
            public int TableContainer; // A number, as the next two.
            public int PlanesContainer; // Of its nodes' planes; unknown until it was loaded, as the next two.
            public int ComputedContainer; // Of planes that were computed.
            public int FirstBelow;
        }

        struct Container
        {
            public ContainerRecord Record;
            public string Path;
            public RemoteFile Remote;
        }

        CloudFolder(string path, CloudManifest manifest)
        {
            FolderPath = path;
            Manifest = manifest;
            Layout = manifest.CreateLayout();
            m_isRemote = SourcePath.IsRemote(path);
            var hierarchy = new ContainerRecord
            {
                Kind = manifest.IsSingleFile ? ContainerKind.SingleFile : ContainerKind.Hierarchy,
                FileBytes = manifest.HierarchyFileBytes,
                Hash = manifest.RootHash,
            };
            Add(manifest.RootPage, AddContainer(SourcePath.Combine(path, manifest.HierarchyName), hierarchy));
        }

        public string FolderPath { get; }
        public CloudManifest Manifest { get; }

        /// <summary>It is being built, or does not have its final name yet: paths in it will change.</summary>
        public bool IsUnfinished => Manifest.IsBuilding ||
            FolderPath.EndsWith(StoreFormat.UnfinishedSuffix, StringComparison.Ordinal);
        public StoreLayout Layout { get; }

        /// <summary>The nodes of page 0.</summary>
        public NodeTable Root { get; private set; }

        internal VerifiedPlanes VerifiedPlanes { get; private set; } // Null unless the folder was opened to be shown.

        /// <summary>The pages that are known so far: page 0, and those that a loaded page links to.</summary>
        public int PageCount => m_pages.Count;

        internal CloudLocalSpace Grid => Manifest.LocalSpace;

        internal PageLink LinkOf(int page) => m_pages[page].Link;

        /// <summary>The number of the first page that a loaded page links to; the others follow in the order of the
        /// links.</summary>
        public int FirstBelow(int page) => m_pages[page].FirstBelow;

        internal ContainerRecord PlanesContainerOf(int page) => m_containers[m_pages[page].PlanesContainer].Record;

        // The same of computed planes, where the cloud has some.
        internal string PathOfComputed(int page) => m_containers[m_pages[page].ComputedContainer].Path;

        internal ContainerRecord ContainerOfComputed(int page) => m_containers[m_pages[page].ComputedContainer].Record;

        internal RemoteFile RemoteOfComputed(int page) => RemoteOfContainer(m_pages[page].ComputedContainer);

        /// <summary>The path of <see cref="PlanesContainerOf"/>.</summary>
        public string PlanesPathOf(int page) => m_containers[m_pages[page].PlanesContainer].Path;

        // On a web server; null on this machine's disk.
        internal RemoteFile PlanesRemoteOf(int page) =>
            m_pages[page].PlanesContainer == Unknown ? null : RemoteOfContainer(m_pages[page].PlanesContainer);

        internal RemoteFile RemoteOfTable(int page) => RemoteOfContainer(m_pages[page].TableContainer);

        internal FilePiece TableOf(int page) => new FilePiece
        {
            Path = m_containers[m_pages[page].TableContainer].Path,
            OffsetBytes = m_pages[page].Link.OffsetBytes,
            LengthBytes = m_pages[page].Link.LengthBytes,
        };

        /// <summary>Whether a cloud is there, if only an unfinished one. Of an address the name alone says so.</summary>
        public static bool IsCloud(string path) => SourcePath.IsRemote(path)
            ? SourcePath.NameOf(path).EndsWith(StoreFormat.FolderExtension, StringComparison.OrdinalIgnoreCase)
            : File.Exists(Path.Combine(FinalOrUnfinished(path), StoreFormat.ManifestName));

        /// <summary>The path itself, or, if that does not exist, that of its unfinished folder if there is one.</summary>
        public static string FinalOrUnfinished(string path)
        {
            string name = path.TrimEnd(Path.DirectorySeparatorChar, Path.AltDirectorySeparatorChar);
            return SourcePath.IsRemote(path) || Directory.Exists(path) ||
                !Directory.Exists(name + StoreFormat.UnfinishedSuffix) ? path : name + StoreFormat.UnfinishedSuffix;
        }

        /// <exception cref="PointCloudException">It is not a cloud, or its manifest or hierarchy is damaged.</exception>
        public static CloudFolder Open(string path)
        {
            path = FinalOrUnfinished(path);
            // An unfinished cloud may get another generation while its files are opened.
            for (int attempt = 0; ; attempt++)
            {
                try
                {
                    return OpenOnce(path);
                }
                catch (PointCloudException) when
                    (attempt < 3 && path.EndsWith(StoreFormat.UnfinishedSuffix, StringComparison.Ordinal))
                {
                    path = FinalOrUnfinished(path.Substring(0, path.Length - StoreFormat.UnfinishedSuffix.Length));
                }
            }
        }

        // The next Open asks a web server what it has by then.
        internal static void MarkStale(string path)
        {
            if (SourcePath.IsRemote(path))
                RemoteFile.Find(SourcePath.Combine(path, StoreFormat.ManifestName))?.MarkStale();
        }

        static CloudFolder OpenOnce(string path)
        {
            string manifestPath = SourcePath.Combine(path, StoreFormat.ManifestName);
            var folder = Open(path, CloudManifest.FromJson(StoreFile.ReadText(manifestPath), manifestPath));
            // What comes from elsewhere is hashed each time.
            if (!folder.m_isRemote)
                folder.VerifiedPlanes = VerifiedPlanes.Of(folder.Manifest.RootHash, folder.IsUnfinished ? null : path);
            return folder;
        }

        /// <summary>Opens a folder that is complete except for cloud.json. Throws if its hierarchy is another one.</summary>
        public static CloudFolder Open(string path, CloudManifest manifest)
        {
            string problem = manifest.FindProblem();
            if (problem != null)
                throw new PointCloudException(FailureCode.BadInput, SourcePath.Combine(path, StoreFormat.ManifestName), -1,
                    problem);
            var folder = new CloudFolder(path, manifest);
            try
            {
                if (folder.m_isRemote)
                    folder.ReadTail();
                folder.Root = folder.LoadPage(0);
                return folder;
            }
            catch
            {
                folder.Dispose();
                throw;
            }
        }

        public void Dispose()
        {
            Root?.Dispose();
            Root = null;
            foreach (var fetched in m_fetched.Values)
                fetched.Dispose();
            m_fetched.Clear();
            DropTail();
        }

        // What is read of the file from now on is asked for again.
        internal void DropTail()
        {
            if (m_tail.IsCreated)
                m_tail.Dispose();
            m_tail = default;
        }

        /// <summary>The nodes of one page, other than the first; the caller disposes the table. The pages below get their
        /// numbers.</summary>
        public NodeTable LoadPage(int page)
        {
            var piece = TableOf(page);
            var table = Check(piece.Path, LinkOf(page), Grid, Layout, m_isRemote ? Fetched(page) : ReadLocal(piece));
            Register(page, table.View);
            return table;
        }

        // Every page, each after the one that links to it; its table lasts until the next.
        internal IEnumerable<NodeTable> EachTable()
        {
            yield return Root;
            for (int page = 1; page < PageCount; page++)
            {
                FetchFrom(page);
                using var table = LoadPage(page);
                yield return table;
            }
        }

        // The files of planes and pages, as far as pages are known.
        internal IEnumerable<(string Path, long Bytes)> Files()
        {
            foreach (var container in m_containers)
                yield return (container.Path, container.Record.FileBytes);
        }

        // For callers that load all pages in this order.
        internal void FetchFrom(int page)
        {
            for (int p = page; m_isRemote && p < Math.Min(page + MaxPagesInFlight, PageCount); p++)
                BeginFetchPage(p);
        }

        // Starts to fetch the page if it is on a web server and is not here. Returns whether LoadPage can run without waiting.
        internal bool BeginFetchPage(int page)
        {
            if (!m_isRemote || IsInTail(page))
                return true;
            if (!m_fetched.TryGetValue(page, out var fetched))
                m_fetched.Add(page, fetched = RemoteOfTable(page).Begin(m_pages[page].Link.OffsetBytes,
                    m_pages[page].Link.LengthBytes, page));
            return fetched.IsDone;
        }

        // Begins to read a page, on any thread, even while the folder is disposed. Whoever takes it registers it.
        internal PoolTask<NodeTable> BeginPage(int page)
        {
            var piece = TableOf(page);
            var remote = RemoteOfTable(page);
            var (link, grid, layout) = (LinkOf(page), Grid, Layout);
            return PoolTask.Begin(piece.Path, () => Check(piece.Path, link, grid, layout, remote == null ? ReadLocal(piece)
                : StoreFile.Read(remote, piece.OffsetBytes, piece.LengthBytes, Allocator.Persistent)), table => table.Dispose());
        }

        // Numbers the pages that a page without problems links to, once.
        internal unsafe void Register(int page, in PageView view)
        {
            var known = m_pages[page];
            if (known.FirstBelow != Unknown)
                return;
            var header = view.Header;
            known.FirstBelow = m_pages.Count;
            known.PlanesContainer = header.NodeCount == 0 ? known.TableContainer
                : NumberOf(view.Containers[view.ContainerOfPlane[0]]);
            known.ComputedContainer = header.NodeCount == 0 ? known.TableContainer
                : NumberOf(view.Containers[view.ContainerOfPlane[header.PlaneCount - 1]]);
            m_pages[page] = known;
            for (int l = 0; l < header.LinkCount; l++)
            {
                var link = view.Links[l];
                Add(link, link.Container < 0 ? known.TableContainer : NumberOf(view.Containers[link.Container]));
            }
        }

        void Add(in PageLink link, int container) => m_pages.Add(new Page
        {
            Link = link,
            TableContainer = container,
            PlanesContainer = Unknown,
            ComputedContainer = Unknown,
            FirstBelow = Unknown,
        });

        int NumberOf(in ContainerRecord record) =>
            AddContainer(SourcePath.Combine(FolderPath, StoreFormat.PathOf(record)), record);

        int AddContainer(string path, in ContainerRecord record)
        {
            if (m_containerOfPath.TryGetValue(path, out int number))
                return number;
            m_containerOfPath.Add(path, m_containers.Count);
            m_containers.Add(new Container { Record = record, Path = path });
            return m_containers.Count - 1;
        }

        // Pages have the hashes of all that is read of it, so that no request goes before the first range.
        RemoteFile RemoteOfContainer(int number)
        {
            var container = m_containers[number];
            if (!m_isRemote || container.Remote != null)
                return container.Remote;
            container.Remote = RemoteFile.Of(container.Path, container.Record.FileBytes,
                Manifest.CloudId.ToString("x16") + container.Record.Hash.ToString("x16"));
            m_containers[number] = container;
            return container.Remote;
        }

        void ReadTail()
        {
            long bytes = Math.Max(Manifest.RootBytes, Math.Min(TailBytes, Manifest.HierarchyFileBytes));
            m_tail = StoreFile.Read(RemoteOfTable(0), Manifest.HierarchyFileBytes - bytes, bytes, Allocator.Persistent);
        }

        bool IsInTail(int page) => m_tail.IsCreated && m_pages[page].TableContainer == 0 &&
            m_pages[page].Link.OffsetBytes >= Manifest.HierarchyFileBytes - m_tail.Length;

        // A page that came with the root's. The memory has room for it.
        internal bool TryCopyPage(int page, NativeArray<byte> to)
        {
            if (!IsInTail(page))
                return false;
            var link = m_pages[page].Link;
            long from = link.OffsetBytes - (Manifest.HierarchyFileBytes - m_tail.Length);
            NativeArray<byte>.Copy(m_tail, (int)from, to, 0, link.LengthBytes);
            return true;
        }

        unsafe NativeArray<byte> Fetched(int page)
        {
            BeginFetchPage(page);
            m_fetched.TryGetValue(page, out var fetched);
            m_fetched.Remove(page);
            using var read = fetched;
            read?.Await();
            var bytes = new NativeArray<byte>(LinkOf(page).LengthBytes, Allocator.Persistent);
            if (read == null)
                TryCopyPage(page, bytes);
            else
                UnsafeUtility.MemCpy(bytes.GetUnsafePtr(), read.Data, bytes.Length);
            return bytes;
        }

        static NativeArray<byte> ReadLocal(in FilePiece piece) =>
            StoreFile.Read(piece.Path, piece.OffsetBytes, piece.LengthBytes, Allocator.Persistent);

        // Takes over the bytes.
        static NodeTable Check(string path, in PageLink link, in CloudLocalSpace grid, StoreLayout layout,
            NativeArray<byte> bytes)
        {
            string problem = NodeTable.FindProblem(bytes, link, grid, layout);
            if (problem == null)
                return new NodeTable(bytes);
            bytes.Dispose();
            throw new PointCloudException(FailureCode.BadInput, path, link.OffsetBytes, problem);
        }
    }
}
