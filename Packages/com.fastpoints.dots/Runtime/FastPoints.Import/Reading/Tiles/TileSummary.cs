using System;
using System.Collections.Generic;
using System.Globalization;
using FastPoints.Core;

namespace FastPoints.Reading
{
    sealed class TileSummary
    {
        readonly SourceInfo m_info;
        readonly SortedDictionary<string, int> m_formats = new SortedDictionary<string, int>(StringComparer.Ordinal);
        string m_firstPath;
        string m_pathOfCrs;
        string m_pathOfOtherCrs;
        int m_otherCrs;
        int m_withoutCrs;
        bool m_hasBounds = true;

        public TileSummary(SourceInfo info)
        {
            m_info = info;
            m_info.PointsReadable = -1;
        }

        public void Include(SourceInfo tile)
        {
            bool isFirst = m_firstPath == null;
            m_firstPath ??= tile.Path;
            m_formats.TryGetValue(tile.Format, out int with);
            m_formats[tile.Format] = with + 1;
            m_info.FileBytes += tile.FileBytes;
            m_info.PointsClaimed = m_info.PointsClaimed <= ulong.MaxValue - tile.PointsClaimed
                ? m_info.PointsClaimed + tile.PointsClaimed
                : ulong.MaxValue;
            m_info.HasPointsClaimed &= tile.HasPointsClaimed;
            if (isFirst)
            {
                m_info.Version = tile.Version;
                m_info.PointFormat = tile.PointFormat;
                m_info.RecordBytes = tile.RecordBytes;
            }
            if (m_info.Version != tile.Version)
                m_info.Version = null;
            if (m_info.PointFormat != tile.PointFormat)
                m_info.PointFormat = -1;
            if (m_info.RecordBytes != tile.RecordBytes)
                m_info.RecordBytes = 0;

            if (tile.HasBoundsClaimed && !tile.BoundsClaimed.IsEmpty)
                m_info.BoundsClaimed.Include(tile.BoundsClaimed);
            m_hasBounds &= tile.HasBoundsClaimed || tile.PointsReadable == 0;
            IncludeCrs(tile);
        }

        void IncludeCrs(SourceInfo tile)
        {
            if (!tile.Crs.IsKnown)
            {
                m_withoutCrs++;
            }
            else if (m_pathOfCrs == null)
            {
                m_pathOfCrs = tile.Path;
                m_info.Crs = tile.Crs;
            }
            else if (!IsSame(m_info.Crs, tile.Crs))
            {
                m_pathOfOtherCrs ??= tile.Path + ": " + tile.Crs.Summary;
                m_otherCrs++;
            }
        }

        public string Describe(SourceInfo tile) => tile.Format + (tile.Version != null ? " " + tile.Version : "") + ", " +
            (tile.PointsReadable >= 0 ? tile.PointsReadable.ToString("N0", CultureInfo.InvariantCulture) + " points" :
                tile.FileBytes.ToString("N0", CultureInfo.InvariantCulture) + " bytes");

        public void End(int tiles)
        {
            var formats = new List<string>();
            foreach (var format in m_formats)
                formats.Add(format.Key + " (" + NumberText.Of(format.Value) + ")");
            m_info.Format = m_formats.Count == 1 ? new List<string>(m_formats.Keys)[0] : "several formats";
            m_info.Facts.Insert(0, new KeyValuePair<string, string>("files",
                tiles.ToString("N0", CultureInfo.InvariantCulture) + ": " + string.Join(", ", formats)));
            m_info.HasBoundsClaimed = m_hasBounds && !m_info.BoundsClaimed.IsEmpty;
            if (m_otherCrs > 0)
                m_info.Warn(-1, "coordinate systems differ: " + m_info.Crs.Summary + " was taken (of " + m_pathOfCrs + "), " +
                    m_otherCrs + " files have others (" + m_pathOfOtherCrs + "): points are not moved between them");
            if (m_pathOfCrs != null && m_withoutCrs > 0)
                m_info.Warn(-1, m_withoutCrs + " files name no coordinate system: that of " + m_pathOfCrs + " was taken");
        }

        static bool IsSame(CoordinateSystem a, CoordinateSystem b)
        {
            if (a.Epsg != 0 && b.Epsg != 0)
                return a.Epsg == b.Epsg && a.VerticalEpsg == b.VerticalEpsg;
            return a.Wkt != null || b.Wkt != null ? a.Wkt == b.Wkt : a.Name == b.Name && a.Epsg == b.Epsg;
        }
    }
}
