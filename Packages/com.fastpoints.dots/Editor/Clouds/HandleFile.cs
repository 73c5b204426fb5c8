using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Base;
using FastPoints.Files;
using FastPoints.Points;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Mathematics;

namespace FastPoints.Editor
{
    /// <summary>Handles on disk: made for a source, read, and brought up to date.</summary>
    internal static class HandleFile
    {
        /// <exception cref="PointCloudException">It cannot be read, or is no handle.</exception>
        public static CloudHandle Read(string path) => CloudHandle.FromJson(StoreFile.ReadText(path), path);

        /// <exception cref="PointCloudException">It cannot be written.</exception>
        public static void Write(string path, CloudHandle handle) => TextFile.Write(path, handle.ToJson());

        /// <summary>Makes a handle for a source, which is not opened; one for a converted cloud says what its manifest
        /// does.</summary>
        /// <param name="source">A file or folder: one cloud.</param>
        /// <param name="folder">Of the handle.</param>
        /// <param name="newTarget">Gives the folder that the cloud will be converted into.</param>
        /// <param name="handle">What was written.</param>
        /// <returns>The handle's path.</returns>
        /// <exception cref="PointCloudException">It cannot be written, or the converted cloud cannot be read.</exception>
        public static string Create(string source, string folder, ProjectPaths paths, Func<string, string> newTarget,
            out CloudHandle handle)
        {
            handle = new CloudHandle();
            if (CloudSources.IsConverted(source))
            {
                string manifest = Path.Combine(source, StoreFormat.ManifestName);
                handle.CloudPath = paths.Stored(source);
                handle.Describe(CloudManifest.FromJson(StoreFile.ReadText(manifest), manifest));
            }
            else
            {
                handle.CloudPath = paths.Stored(newTarget(source));
                handle.Sources.Add(paths.Stored(source));
                handle.IsOctree = CloudSources.BringsOctree(source);
            }
            var taken = new HashSet<string>(StringComparer.OrdinalIgnoreCase);
            foreach (string file in Directory.GetFileSystemEntries(folder))
                taken.Add(Path.GetFileName(file));
            // The folder's extension says what the handle's own does.
            string wanted = CloudName.Of(source);
            if (handle.Sources.Count == 0)
                wanted = Path.GetFileNameWithoutExtension(wanted);
            string name = AssetNaming.Unique(wanted, n => taken.Contains(n + CloudHandle.Extension));
            string path = Path.Combine(folder, name + CloudHandle.Extension);
            Write(path, handle);
            return path;
        }

        /// <summary>After a conversion: what was found, and the stamp that its source had.</summary>
        /// <param name="origin">Where scenes show the cloud; kept from then on. Null for where the manifest puts it.</param>
        /// <param name="up">On whose floor that is.</param>
        /// <param name="source">What was converted, with its warnings; may be null.</param>
        public static void Update(string path, CloudManifest manifest, SourceStamp stamp, double3? origin = null,
            UpAxis up = UpAxis.Z, SourceInfo source = null)
        {
            var handle = Read(path);
            string before = handle.ToJson();
            handle.Describe(manifest);
            if (handle.Origin == null)
                handle.OriginUp = up;
            handle.Origin ??= origin ?? UnitySpace.Of(manifest.BoundsGeo, manifest.MetresPerUnit, up).OriginGeo;
            if (source != null)
                handle.Describe(source.Format, source.Warnings);
            // A time that version control has touched is no reason to write.
            if (handle.Stamp == null || !handle.Stamp.HasBytesOf(stamp))
                handle.Stamp = stamp;
            if (handle.ToJson() != before)
                Write(path, handle);
        }
    }
}
