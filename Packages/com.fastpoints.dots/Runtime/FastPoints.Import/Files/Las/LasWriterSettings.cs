using System;
using FastPoints.Points;
using Unity.Mathematics;

namespace FastPoints.Files
{
    /// <summary>What a LAS file to be written is.</summary>
    public sealed class LasWriterSettings
    {
        /// <summary>LAS 1.0 to 1.5: 0 to 5. Point formats 4 and 5 need 1.3, those from 6 on 1.4.</summary>
        public int VersionMinor = 4;

        /// <summary>0 to 10.</summary>
        public int PointFormat = 7;

        /// <summary>Position = stored * scale + offset; finite, the scale not 0.</summary>
        public double3 Scale = new double3(0.001, 0.001, 0.001);

        public double3 Offset;

        /// <summary>The CRS as OGC well-known text, or null.</summary>
        public string Wkt;

        public string SystemIdentifier = "OTHER";
        public string GeneratingSoftware = "FastPoints";

        /// <summary>Day of the year and year; 0 where not stated, so that equal clouds give equal files.</summary>
        public int CreationDay;
        public int CreationYear;

        /// <summary>Attributes beyond the point format's, in the order of the record.</summary>
        public PointAttribute[] ExtraBytes = Array.Empty<PointAttribute>();
    }
}
