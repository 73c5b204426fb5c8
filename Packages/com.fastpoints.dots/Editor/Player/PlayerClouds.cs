using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Text;
using FastPoints.Store;

namespace FastPoints.Editor
{
    internal sealed class PlayerClouds
    {
        public struct Entry
        {
            public string DiskPath;

            public string PlayerPath; // Path below the player's streaming assets.

            public long Points; // -1 if unknown.
            public long Bytes;

            public bool IsSource; // Whether it is not converted: FastPoints.Import, which reads it, must be in the player.
        }

        readonly List<Entry> m_entries = new List<Entry>();

        public IReadOnlyList<Entry> Entries => m_entries;

        public bool HasSources => m_entries.Exists(e => e.IsSource);

        /// <summary>Adds a cloud, only once if several assets refer to it.</summary>
        /// <param name="asset">Whose cloud it is, for messages.</param>
        /// <param name="cloudId">The id in the asset; 0 if unknown.</param>
        /// <exception cref="PointCloudException">It is not converted, is unfinished, or another cloud has its
        /// place.</exception>
        public void Add(string asset, string folder, string playerPath, ulong cloudId = 0)
        {
            bool isKnown = IsAddedOrThrow(asset, folder, playerPath);
            string manifestPath = Path.Combine(folder, StoreFormat.ManifestName);
            if (!File.Exists(manifestPath))
                throw new PointCloudException(FailureCode.NotFound, asset, -1, "is not converted: wanted a cloud in " + folder +
                    (CloudFolder.IsCloud(folder) ? ", got one in the making" : ""));
            var manifest = CloudManifest.FromJson(StoreFile.ReadText(manifestPath), manifestPath);
            if (cloudId != 0 && manifest.CloudId != cloudId)
                throw new PointCloudException(FailureCode.NotFound, asset, -1,
                    "was converted again elsewhere: got another cloud in " + folder);
            if (isKnown)
                return;
            long bytes = BytesOf(folder);
            m_entries.Add(new Entry { DiskPath = folder, PlayerPath = playerPath, Points = manifest.Points, Bytes = bytes });
        }

        /// <summary>Adds a cloud that is streamed directly, only once if several assets refer to it.</summary>
        /// <param name="asset">Whose cloud it is, for messages.</param>
        /// <param name="source">The file or folder.</param>
        /// <param name="points">-1 if unknown.</param>
        /// <exception cref="PointCloudException">It does not exist, or another cloud has its place.</exception>
        public void AddSource(string asset, string source, string playerPath, long points)
        {
            if (IsAddedOrThrow(asset, source, playerPath))
                return;
            if (!File.Exists(source) && !Directory.Exists(source))
                throw new PointCloudException(FailureCode.NotFound, asset, -1,
                    "is neither converted nor is there its source: wanted " + source);
            m_entries.Add(new Entry
            {
                DiskPath = source,
                PlayerPath = playerPath,
                Points = points,
                Bytes = File.Exists(source) ? new FileInfo(source).Length : BytesOf(source),
                IsSource = true,
            });
        }

        bool IsAddedOrThrow(string asset, string folder, string playerPath)
        {
            int known = m_entries.FindIndex(e => string.Equals(e.PlayerPath, playerPath, StringComparison.OrdinalIgnoreCase));
            if (known >= 0 && m_entries[known].DiskPath != folder)
                throw PointCloudException.Wanted(FailureCode.WriteFailed, asset, -1, "place in the player " + playerPath,
                    folder, m_entries[known].DiskPath);
            return known >= 0;
        }

        public long Bytes
        {
            get
            {
                long bytes = 0;
                foreach (var entry in m_entries)
                    bytes += entry.Bytes;
                return bytes;
            }
        }

        static long BytesOf(string folder)
        {
            long bytes = 0;
            foreach (var file in new DirectoryInfo(folder).GetFiles("*", SearchOption.AllDirectories))
                bytes += file.Length;
            return bytes;
        }

        public string Report()
        {
            var sorted = new List<Entry>(m_entries);
            sorted.Sort((a, b) => b.Bytes.CompareTo(a.Bytes));
            var text = new StringBuilder();
            foreach (var entry in sorted)
                text.AppendFormat(CultureInfo.InvariantCulture, "\n{0,10:0.0} MB  {1,15} points  {2}{3}", entry.Bytes * 1e-6,
                    entry.Points < 0 ? "?" : entry.Points.ToString("N0", CultureInfo.InvariantCulture), entry.PlayerPath,
                    entry.IsSource ? " as it is, with FastPoints.Import" : "");
            return string.Format(CultureInfo.InvariantCulture, "{0} point clouds in the player, {1:0.0} MB", sorted.Count,
                Bytes * 1e-6) + text;
        }
    }
}
