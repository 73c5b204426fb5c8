using System.Collections.Generic;
using System.IO;
using FastPoints.Reading;
using FastPoints.Sources;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Mathematics;

namespace FastPoints.Editor
{
    internal static class HandleFile
    {
        /// <exception cref="PointCloudException">It cannot be read, or is not a handle.</exception>
        public static CloudHandle Read(string path) => CloudHandle.FromJson(StoreFile.ReadText(path), path);

        /// <summary>Main thread.</summary>
        /// <exception cref="PointCloudException">It is locked, or cannot be written.</exception>
        public static void Write(string path, CloudHandle handle)
        {
            VersionedFile.CheckOut(path);
            TextFile.Write(path, handle.ToJson());
        }

        public static FreePaths FreeHandlePaths(string folder) =>
            new FreePaths(folder, CloudHandle.Extension, Directory.GetFileSystemEntries(folder));

        /// <summary>Creates a handle for sources; for a converted cloud it copies facts from the manifest. Any thread.</summary>
        /// <param name="sources">Files and folders: one cloud.</param>
        /// <param name="handles">Names of handles, in the folder of this one.</param>
        /// <param name="clouds">Names of the folders that clouds are converted into.</param>
        /// <param name="readsHeader">Whether the source is opened for what its header claims.</param>
        /// <param name="handle">The handle that was written.</param>
        /// <returns>The handle's path.</returns>
        /// <exception cref="PointCloudException">It cannot be written, or the converted cloud cannot be read.</exception>
        public static string Create(IReadOnlyList<string> sources, ProjectPaths paths, FreePaths handles, FreePaths clouds,
            bool readsHeader, out CloudHandle handle)
        {
            handle = new CloudHandle();
            string name = NameOf(sources);
            if (CloudSources.IsConverted(sources[0]))
            {
                string manifest = Path.Combine(sources[0], StoreFormat.ManifestName);
                handle.CloudPath = paths.Stored(sources[0]);
                handle.SetFrom(CloudManifest.FromJson(StoreFile.ReadText(manifest), manifest));
                // The folder's extension says the same as the handle's own.
                name = Path.GetFileNameWithoutExtension(name);
            }
            else
            {
                handle.CloudPath = paths.Stored(clouds.Next(name));
                foreach (string source in sources)
                    handle.Sources.Add(paths.Stored(source));
                handle.IsSourceFolder = sources.Count == 1 && Directory.Exists(sources[0]);
                handle.IsSourceOctree = sources.Count == 1 && CloudSources.HasOctree(sources[0]);
                if (readsHeader)
                    Describe(handle, sources);
            }
            string path = handles.Next(name);
            // A new file need not survive a crash, and a thousand flushes take seconds.
            TextFile.Write(path, handle.ToJson(), false);
            return path;
        }

        /// <summary>A source that cannot be opened has no description: showing or converting it reports why.</summary>
        static void Describe(CloudHandle handle, IReadOnlyList<string> sources)
        {
            try
            {
                var reader = PointReaders.Open(sources);
                handle.SetFrom(reader.Info);
                reader.DisposeUnread();
            }
            catch (PointCloudException)
            {
            }
        }

        /// <summary>Several files are named after their folder, if they lie in one.</summary>
        static string NameOf(IReadOnlyList<string> sources)
        {
            string folder = Path.GetDirectoryName(Path.GetFullPath(sources[0]));
            for (int i = 1; i < sources.Count; i++)
                if (Path.GetDirectoryName(Path.GetFullPath(sources[i])) != folder)
                    return CloudName.Of(sources[0]);
            return CloudName.Of(sources.Count > 1 ? folder : sources[0]);
        }

        /// <summary>Updates a handle after a conversion with its results and the stamp of its source.</summary>
        /// <param name="origin">Where scenes show a cloud whose source claims no bounds. Null to take the manifest's
        /// place.</param>
        /// <param name="up">The up axis that the origin was computed with.</param>
        /// <param name="source">What was converted, with its warnings; may be null.</param>
        public static void Update(string path, CloudManifest manifest, SourceStamp stamp, double3? origin = null,
            UpAxis up = UpAxis.Z, SourceInfo source = null)
        {
            var handle = Read(path);
            string before = handle.ToJson();
            handle.SetFrom(manifest);
            if (handle.Origin == null)
                handle.OriginUp = up;
            // The header's bounds, if any: every machine finds the same origin, and the preview was placed with it.
            handle.Origin ??= source != null && !source.BoundsIfFinite.IsEmpty
                ? UnityLocalSpace.Of(source.BoundsIfFinite, source.Crs.Units, up).OriginGeo
                : origin ?? UnityLocalSpace.Of(manifest.BoundsGeo, manifest.Crs.Units, up).OriginGeo;
            if (source != null)
                handle.SetFrom(source.Format, source.Warnings);
            handle.Stamp = stamp;
            if (handle.ToJson() != before)
                Write(path, handle);
        }
    }
}
