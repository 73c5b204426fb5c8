namespace FastPoints
{
    /// <summary>A cloud's coordinate system, as far as it is known.</summary>
    public sealed class CloudCrs
    {
        /// <summary>A readable name: one line, or null.</summary>
        public string Name;

        /// <summary>OGC well-known text, or null.</summary>
        public string Wkt;

        /// <summary>EPSG codes of the horizontal (or compound) and of the vertical system, or 0.</summary>
        public int Epsg;
        public int VerticalEpsg;

        /// <summary>Metres of a horizontal unit; 0 if unknown, NaN for degrees.</summary>
        public double MetresPerUnit;

        /// <summary>Metres of a vertical unit; 0 if nothing says it.</summary>
        public double VerticalMetresPerUnit;

        public CloudUnits Units => new CloudUnits(MetresPerUnit, VerticalMetresPerUnit);
        internal byte[][] GeoKeys; // GeoTIFF keys as LAS has them: directory, doubles, text; null without keys.

        // What distinguishes entries in the list of a cloud's sources.
        internal bool IsSameEntryAs(CloudCrs other) => other != null && Name == other.Name && Wkt == other.Wkt &&
            Epsg == other.Epsg && VerticalEpsg == other.VerticalEpsg;

        /// <summary>Whether both are known to be the same system.</summary>
        public bool IsSameAs(CloudCrs other) =>
            Epsg != 0 && Epsg == other.Epsg && VerticalEpsg == other.VerticalEpsg ||
            !string.IsNullOrEmpty(Wkt) && Wkt == other.Wkt;
    }
}
