using System.Collections.Generic;
using FastPoints.Store;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Build
{
    /// <summary>Writes the pages of a cloud anew, in their order, with one more plane; normals that they had are left out. Nodes
    /// stay in their pages, which get a tenth larger.</summary>
    internal static unsafe class NormalPages
    {
        const int BytesPerPiece = 4 << 20;

        public static IEnumerator<JobStep> Write(CloudFolder folder, CloudManifest manifest, NormalContainers normals,
            WriteQueue queue)
        {
            string path = SourcePath.Combine(folder.FolderPath, manifest.HierarchyName);
            var order = new List<int>();
            for (int page = 0; page < folder.PageCount; page++)
                order.Add(page);
            // Each comes behind those that it links to.
            order.Sort((a, b) => folder.LinkOf(a).OffsetBytes.CompareTo(folder.LinkOf(b).OffsetBytes));
            var links = new PageLink[folder.PageCount];
            using var bytes = new NativeList<byte>(BytesPerPiece, Allocator.Persistent);
            long written = FileHeader.SizeBytes;
            foreach (int page in order)
            {
                var piece = folder.TableOf(page);
                using (var old = StoreFile.Read(piece.Path, piece.OffsetBytes, piece.LengthBytes, Allocator.Persistent))
                {
                    int start = bytes.Length;
                    Append(folder, page, PageView.Of(old), normals, links, bytes);
                    links[page].OffsetBytes = written + start;
                    links[page].LengthBytes = bytes.Length - start;
                    links[page].Hash = HashOf(bytes, start);
                }
                if (bytes.Length >= BytesPerPiece || page == 0)
                {
                    yield return JobStep.Of(CloudFolderWriter.Await(queue.WritePiece(path, bytes.AsArray(), written)));
                    written += bytes.Length;
                    bytes.Clear();
                }
                yield return default;
            }
            manifest.HierarchyFileBytes = written;
            manifest.RootOffset = links[0].OffsetBytes;
            manifest.RootBytes = links[0].LengthBytes;
            manifest.RootHash = links[0].Hash;
            using var header = new NativeArray<byte>(HierarchyFile.HeaderOf(manifest, manifest.CreateLayout().Planes.Count),
                Allocator.Persistent);
            yield return JobStep.Of(CloudFolderWriter.Await(queue.Seal(path, header)));
        }

        static ulong HashOf(NativeList<byte> bytes, int start) =>
            ContentHash.Of(bytes.GetUnsafePtr() + start, bytes.Length - start);

        static void Append(CloudFolder folder, int page, in PageView old, NormalContainers normals, PageLink[] links,
            NativeList<byte> to)
        {
            var was = old.Header;
            int built = was.PlaneCount - folder.Layout.ComputedPlaneCount;
            bool hasNodes = was.NodeCount > 0;
            var header = was;
            header.PlaneCount = built + 1;
            header.ContainerCount = hasNodes ? 2 : 0;
            int start = to.Length;
            to.Resize(start + (int)header.LengthBytes, NativeArrayOptions.ClearMemory);
            byte* at = to.GetUnsafePtr() + start;
            *(PageHeader*)at = header;
            var view = new PageView { Bytes = at };
            if (hasNodes)
            {
                view.Containers[0] = folder.PlanesContainerOf(page);
                view.Containers[1] = normals.ContainerOf(page);
                view.ContainerOfPlane[built] = 1;
            }
            UnsafeUtility.MemCpy(view.Nodes, old.Nodes, (long)was.NodeCount * NodeRecord.SizeBytes);
            for (int n = 0; n < was.NodeCount; n++)
            {
                for (int p = 0; p < built; p++)
                    view.Ranges[n * header.PlaneCount + p] = old.Ranges[n * was.PlaneCount + p];
                view.Ranges[n * header.PlaneCount + built] = new PackedRange(normals.RangeOf(page, n));
            }
            for (int l = 0; l < was.LinkCount; l++)
            {
                var below = links[folder.FirstBelow(page) + l];
                var link = old.Links[l];
                (link.OffsetBytes, link.LengthBytes, link.Hash) = (below.OffsetBytes, below.LengthBytes, below.Hash);
                link.Container = -1;
                view.Links[l] = link;
            }
        }
    }
}
