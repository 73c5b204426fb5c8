using System.Globalization;
using Unity.Mathematics;

namespace FastPoints
{
    /// <summary>Lengths of a cloud's coordinate units in metres.</summary>
    public struct CloudUnits
    {
        // WGS 84. On other ellipsoids a degree is up to a ten-thousandth longer or shorter.
        const double EquatorRadius = 6_378_137;
        const double EccentricitySq = 6.694379990141e-3;
        const double MaxLatitude = 89.99; // Nearer to a pole a degree of longitude has no useful length.

        /// <summary>Metres of a horizontal unit; 0 if unknown, NaN if X is a longitude and Y a latitude, in degrees.</summary>
        public double Horizontal;

        /// <summary>Metres of a vertical unit; 0 if nothing says it: then it is the horizontal one, or the metre beside
        /// degrees.</summary>
        public double Vertical;

        public CloudUnits(double horizontal, double vertical = 0)
        {
            Horizontal = horizontal;
            Vertical = vertical;
        }

        public readonly bool IsInDegrees => double.IsNaN(Horizontal);

        public readonly bool IsKnown => IsInDegrees || IsLength(Horizontal);

        /// <summary>Metres of a unit along each axis around a position; 1 if they are unknown.</summary>
        /// <param name="geo">Counts for degrees alone: a degree of longitude is shorter at higher latitudes.</param>
        public readonly double3 MetresAt(double3 geo, UpAxis up)
        {
            double across = IsLength(Horizontal) ? Horizontal : 1;
            var metres = new double3(across, across, across);
            if (IsLength(Vertical))
                metres[up.Index()] = Vertical;
            else if (IsInDegrees)
                metres[up.Index()] = 1;
            if (!IsInDegrees || up != UpAxis.Z || !CouldBeDegrees(geo))
                return metres;
            double latitude = math.radians(math.clamp(geo.y, -MaxLatitude, MaxLatitude)), height = geo.z * metres.z;
            double sine = math.sin(latitude), flattening = 1 - EccentricitySq * sine * sine;
            double east = EquatorRadius / math.sqrt(flattening), north = east * (1 - EccentricitySq) / flattening;
            metres.x = math.radians(east + height) * math.cos(latitude);
            metres.y = math.radians(north + height);
            return metres;
        }

        /// <summary>How far, in metres, a corner of a box is at most from where it belongs if <see cref="MetresAt"/> of the
        /// middle of its floor puts it there: 8 cm at 1 km from there and 8 m at 10 km, by the curvature of the earth, and
        /// more where a degree of longitude is not as long at all latitudes of the box. 0 for lengths.</summary>
        public readonly double PlacementError(BoundsGeo bounds)
        {
            if (bounds.IsEmpty)
                return 0;
            var origin = new double3(bounds.Center.xy, bounds.Min.z);
            var metres = MetresAt(origin, UpAxis.Z);
            if (!IsInDegrees || metres.x == 1)
                return 0;
            double longitude = math.radians(origin.x), latitude = math.radians(origin.y);
            math.sincos(longitude, out double sinLon, out double cosLon);
            math.sincos(latitude, out double sinLat, out double cosLat);
            var east = new double3(-sinLon, cosLon, 0);
            var north = new double3(-sinLat * cosLon, -sinLat * sinLon, cosLat);
            var up = new double3(cosLat * cosLon, cosLat * sinLon, sinLat);
            var centre = Geocentric(origin, metres.z);
            double worstSq = 0;
            for (int corner = 0; corner < 8; corner++)
            {
                var geo = new double3((corner & 1) == 0 ? bounds.Min.x : bounds.Max.x, (corner & 2) == 0 ? bounds.Min.y
                    : bounds.Max.y, (corner & 4) == 0 ? bounds.Min.z : bounds.Max.z);
                var from = Geocentric(geo, metres.z) - centre;
                var belongs = new double3(math.dot(from, east), math.dot(from, north), math.dot(from, up));
                worstSq = math.max(worstSq, math.distancesq((geo - origin) * metres, belongs));
            }
            return math.sqrt(worstSq);
        }

        /// <summary>In words, such as "US survey feet, heights in metres".</summary>
        /// <param name="bounds">For the error of degrees; empty if unknown.</param>
        public readonly string Describe(BoundsGeo bounds)
        {
            if (!IsKnown)
                return "UNKNOWN, taken for metres";
            string heights = IsLength(Vertical) && Vertical != Horizontal ? ", heights in " + NameOf(Vertical) : "";
            return (IsInDegrees ? "degrees" : NameOf(Horizontal)) + heights + (!IsInDegrees || bounds.IsEmpty ? "" :
                "; shown in metres around the centre, corners are " +
                PlacementError(bounds).ToString("G2", CultureInfo.InvariantCulture) + " m wrong");
        }

        /// <summary>Whether X and Y can be a longitude and a latitude in degrees.</summary>
        public static bool CouldBeDegrees(double3 geo) => geo.x >= -180 && geo.x <= 360 && geo.y >= -90 && geo.y <= 90;

        static string NameOf(double metres) => metres == 1 ? "metres" : math.abs(metres - 0.3048) < 1e-8 ? "feet"
            : math.abs(metres - 1200.0 / 3937) < 1e-8 ? "US survey feet"
            : metres.ToString("0.######", CultureInfo.InvariantCulture) + " metres";

        static bool IsLength(double metres) => metres > 0 && metres <= double.MaxValue;

        static double3 Geocentric(double3 geo, double metresUp)
        {
            math.sincos(math.radians(geo.x), out double sinLon, out double cosLon);
            math.sincos(math.radians(geo.y), out double sinLat, out double cosLat);
            double radius = EquatorRadius / math.sqrt(1 - EccentricitySq * sinLat * sinLat), height = geo.z * metresUp;
            return new double3((radius + height) * cosLat * cosLon, (radius + height) * cosLat * sinLon,
                (radius * (1 - EccentricitySq) + height) * sinLat);
        }
    }
}
