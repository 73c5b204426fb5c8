using FastPoints.Points;

namespace FastPoints.Files
{
    /// <summary>The coordinate reference system as far as the file names it. Kept and shown, never used to move points.</summary>
    public sealed class CoordinateSystem
    {
        /// <summary>OGC well-known text, or null.</summary>
        public string Wkt;

        /// <summary>EPSG code of the horizontal (or compound) system, or 0.</summary>
        public int Epsg;

        /// <summary>EPSG code of the vertical system, or 0.</summary>
        public int VerticalEpsg;

        /// <summary>For people: the system's name, or null.</summary>
        public string Name;

        /// <summary>Metres of one horizontal unit (0.3048 for feet); 0 where unknown; NaN where the unit is an angle.</summary>
        public double MetresPerUnit;

        public CloudCrs ToCloudCrs() => new CloudCrs
        {
            Name = Summary,
            Wkt = Wkt,
            Epsg = Epsg,
            VerticalEpsg = VerticalEpsg,
            MetresPerUnit = MetresPerUnit,
        };

        public bool IsKnown => Wkt != null || Epsg != 0 || Name != null;

        /// <summary>One line: name, EPSG code; null where nothing is known.</summary>
        public string Summary
        {
            get
            {
                string code = Epsg != 0 ? "EPSG:" + Epsg + (VerticalEpsg != 0 ? "+" + VerticalEpsg : "") : null;
                if (Name != null)
                    return code != null ? Name + " (" + code + ")" : Name;
                return code ?? (Wkt != null ? "WKT without a name" : null);
            }
        }
    }
}
