using FastPoints.Core;

namespace FastPoints.Reading
{
    /// <summary>The coordinate reference system as far as the file names it. It is kept and shown, but never used to move
    /// points.</summary>
    public sealed class CoordinateSystem
    {
        /// <summary>OGC well-known text, or null.</summary>
        public string Wkt;

        /// <summary>EPSG code of the horizontal (or compound) system, or 0.</summary>
        public int Epsg;

        /// <summary>EPSG code of the vertical system, or 0.</summary>
        public int VerticalEpsg;

        /// <summary>The system's name for people, or null.</summary>
        public string Name;

        /// <summary>Metres of one horizontal unit (0.3048 for feet); 0 if unknown; NaN if the unit is an angle.</summary>
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

        /// <summary>Name and EPSG code in one line; null if nothing is known.</summary>
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
