using System;
using System.Collections.Generic;
using System.Globalization;
using FastPoints.Queries;
using Unity.Mathematics;

namespace FastPoints.Editor
{
    internal static class PickText
    {
        const int MaxDecimals = 12;

        public static List<string> Describe(StreamPick pick)
        {
            var lines = new List<string>
            {
                Coordinates(pick.Point.PositionGeo, pick.Point.Grid.Step) +
                    (string.IsNullOrEmpty(pick.Crs.Name) ? "" : "  " + pick.Crs.Name),
            };
            foreach (var attribute in pick.Point.Attributes)
            {
                string name = attribute.Attribute.Name == AttributeNames.Classification
                    ? ClassNames.Of((int)attribute.Value)
                    : null;
                lines.Add(attribute.Attribute.Name + "  " + attribute + (name == null ? "" : "  " + name));
            }
            return lines;
        }

        /// <summary>The distance, and its parts along the axes of the coordinate system.</summary>
        public static List<string> Describe(Measurement measured, double3 step)
        {
            var lines = new List<string>();
            if (!measured.HasOneCrs)
            {
                lines.Add("Distance  " + Rounded(measured.WorldLength) + " (scene; other coordinate systems)");
                return lines;
            }
            var units = measured.Units;
            lines.Add("Distance  " +
                (units.IsKnown ? Rounded(measured.LengthMetres) + " m" : Rounded(measured.LengthGeo) + " units"));
            bool isOneUnit = units.Vertical == 0 || units.Vertical == units.Horizontal;
            if (units.Horizontal > 0 && units.Horizontal != 1 && isOneUnit)
                lines.Add("Distance  " + Rounded(measured.LengthGeo) + " units of " + Rounded(units.Horizontal) + " m");
            lines.Add("Across  " + (units.IsKnown ? Rounded(measured.HorizontalMetres) + " m"
                : Rounded(measured.HorizontalGeo) + " units"));
            lines.Add("dx, dy, dz  " + Coordinates(measured.DeltaGeo, step));
            return lines;
        }

        /// <summary>Three numbers with as many decimals as the grid's steps have.</summary>
        public static string Coordinates(double3 position, double3 step) =>
            Number(position.x, step.x) + ", " + Number(position.y, step.y) + ", " + Number(position.z, step.z);

        static string Number(double value, double step)
        {
            int decimals = 0;
            // A step of 0.001 needs three decimals, one of 2^-7 seven: until it is whole, as far as doubles can resolve.
            for (double scaled = step; decimals < MaxDecimals && Math.Abs(scaled - Math.Round(scaled)) > 1e-6 * scaled;)
                scaled = step * Math.Pow(10, ++decimals);
            return value.ToString("F" + decimals, CultureInfo.InvariantCulture);
        }

        static string Rounded(double value) => value.ToString("0.####", CultureInfo.InvariantCulture);
    }
}
