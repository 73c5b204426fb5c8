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
    /// <summary>Reads, writes, makes and updates handles on disk.</summary>
    internal static class HandleFile
    {
        /// <exception cref="PointCloudException">It cannot be read, or is not a handle.</exception>
        public static CloudHandle Read(string path) => CloudHandle.FromJson(StoreFile.ReadText(path), path);

        /// <exception cref="PointCloudException">It cannot be written.</exception>
        public static void Write(string path, CloudHandle handle) => TextFile.Write(path, handle.ToJson());

        /// <summary>Makes a handle for a source without opening it; a handle for a converted cloud takes over its
        /// manifest.</summary>
        /// <param name="source">A file or folder: one cloud.</param>
        /// <param name="folder">The handle's folder.</param>
        /// <param name="newTarget">Gives the folder that the cloud will be converted into.</param>
        /// <param name="handle">The handle that was written.</param>
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
            // The folder's extension says the same as the handle's own.
            string wanted = CloudName.Of(source);
            if (handle.Sources.Count == 0)
                wanted = Path.GetFileNameWithoutExtension(wanted);
            string name = AssetNaming.Unique(wanted, n => taken.Contains(n + CloudHandle.Extension));
            string path = Path.Combine(folder, name + CloudHandle.Extension);
            Write(path, handle);
            return path;
        }

        /// <summary>Updates a handle after a conversion with its results and the stamp of its source.</summary>
        /// <param name="origin">Where scenes show the cloud; kept from then on. Null to take the manifest's place.</param>
        /// <param name="up">The axis whose floor that is on.</param>
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
            // A timestamp that version control has touched is no reason to write.
            if (handle.Stamp == null || !handle.Stamp.HasBytesOf(stamp))
                handle.Stamp = stamp;
            if (handle.ToJson() != before)
                Write(path, handle);
        }
    }
}
