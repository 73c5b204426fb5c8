using System;
using System.Collections.Generic;
using FastPoints.Reading;
using Unity.Mathematics;

namespace FastPoints.E57
{
    sealed class E57Scan
    {
        public const int MaxFields = 250; // More bytestreams than any real prototype has.

        // In the file: the list lacks scans that cannot be read.
        public int Index;
        public string Name;
        public ulong RecordsClaimed;
        public ulong SectionOffset; // Physical, of its binary section.

        public readonly List<E57Field> Fields = new List<E57Field>();
        public E57Pose Pose = E57Pose.Identity;
        public bool IsScannerKnown; // Without a pose, positions from elsewhere may have been written as those of a scanner.
        public BoundsGeo BoundsClaimed = BoundsGeo.Empty; // In the scanner's own coordinates; empty if the file does not say.

        // NaN if the file does not say.
        public double2[] ColorLimits;
        public double2 IntensityLimits;

        public E57Field Field(string name)
        {
            foreach (var field in Fields)
                if (field.Name == name)
                    return field;
            return null;
        }

        // Null if one is missing or not a number.
        public E57Field[] FindTriple(string[] names)
        {
            var three = new E57Field[3];
            for (int i = 0; i < 3; i++)
            {
                three[i] = Field(names[i]);
                if (three[i] == null || three[i].Kind == E57FieldKind.String)
                    return null;
            }
            return three;
        }

        public bool IsCartesian => FindTriple(E57Names.Cartesian) != null;
        public string Label => "scan " + NumberText.Of(Index + 1L);

        public long RecordBits
        {
            get
            {
                long bits = 0;
                foreach (var one in Fields)
                    bits += one.Bits > 0 ? one.Bits : 0;
                return bits;
            }
        }

        // problem: why it cannot be read; comment: what was assumed; otherwise null.
        public static E57Scan Read(E57Node node, int index, out string problem, out string comment)
        {
            var scan = new E57Scan { Index = index, Name = node.TextOf("name") };
            scan.Pose = E57Pose.Read(node.Child("pose"), out comment);
            scan.ReadLimits(node);
            problem = scan.ReadPoints(node.Child("points"));
            scan.IsScannerKnown = node.Child("pose") != null || !scan.IsCartesian;
            return scan;
        }

        string ReadPoints(E57Node points)
        {
            if (points == null || points.Type != "CompressedVector")
                return "it has no points of type CompressedVector";
            if (!E57Text.TryCount(points.Attribute("recordCount"), out RecordsClaimed))
                return "recordCount: got \"" + E57Text.OneLine(points.Attribute("recordCount") ?? "") + "\"";
            if (!E57Text.TryCount(points.Attribute("fileOffset"), out SectionOffset))
                return "fileOffset: got \"" + E57Text.OneLine(points.Attribute("fileOffset") ?? "") + "\"";
            var prototype = points.Child("prototype");
            if (prototype == null)
                return "its points have no prototype";
            string problem = ReadFields(prototype, "");
            if (problem != null)
                return problem;
            var codecs = points.Child("codecs");
            if (codecs != null)
                foreach (var codec in codecs.Children)
                    if (codec.Child("bitPackCodec") == null && codec.Children.Count > 0)
                        return "codec " + codec.Children[codec.Children.Count - 1].Name + " is not known: wanted bitPackCodec";
            return IsCartesian || FindTriple(E57Names.Spherical) != null
                ? null
                : "its points have neither " + string.Join(", ", E57Names.Cartesian) + " nor " +
                    string.Join(", ", E57Names.Spherical);
        }

        string ReadFields(E57Node structure, string path)
        {
            foreach (var child in structure.Children)
            {
                string name = path + child.Name;
                if (child.Type == "Structure")
                {
                    string within = ReadFields(child, name + "/");
                    if (within != null)
                        return within;
                    continue;
                }
                if (Fields.Count == MaxFields)
                    return "wanted at most " + MaxFields + " fields, got more";
                if (Field(name) != null)
                    return "field " + name + " is there twice";
                var field = E57Field.Read(child, name, Fields.Count, out string problem);
                if (field == null)
                    return problem;
                Fields.Add(field);
            }
            return null;
        }

        void ReadLimits(E57Node node)
        {
            var colors = node.Child("colorLimits");
            ColorLimits = new[]
            {
                Limits(colors, "colorRedMinimum", "colorRedMaximum"),
                Limits(colors, "colorGreenMinimum", "colorGreenMaximum"),
                Limits(colors, "colorBlueMinimum", "colorBlueMaximum"),
            };
            IntensityLimits = Limits(node.Child("intensityLimits"), "intensityMinimum", "intensityMaximum");
            var box = node.Child("cartesianBounds");
            double2 x = Limits(box, "xMinimum", "xMaximum"), y = Limits(box, "yMinimum", "yMaximum"),
                z = Limits(box, "zMinimum", "zMaximum");
            var bounds = new BoundsGeo(new double3(x.x, y.x, z.x), new double3(x.y, y.y, z.y));
            // Writers that do not know the bounds put the largest doubles there.
            if (bounds.IsFinite && !bounds.IsEmpty && math.cmax(math.abs(bounds.Min)) < 1e30 &&
                math.cmax(math.abs(bounds.Max)) < 1e30)
                BoundsClaimed = bounds;
        }

        static double2 Limits(E57Node node, string min, string max) =>
            node == null ? new double2(double.NaN, double.NaN) : new double2(node.NumberOf(min), node.NumberOf(max));
    }

    static class E57Names
    {
        public const string CartesianInvalid = "cartesianInvalidState";
        public const string SphericalInvalid = "sphericalInvalidState";
        public const string ReturnIndex = "returnIndex";
        public const string Intensity = "intensity";

        public static readonly string[] Cartesian = { "cartesianX", "cartesianY", "cartesianZ" };
        public static readonly string[] Spherical = { "sphericalRange", "sphericalAzimuth", "sphericalElevation" };
        public static readonly string[] Colors = { "colorRed", "colorGreen", "colorBlue" };
        public static readonly string[] Normals = { "nor:normalX", "nor:normalY", "nor:normalZ" };

        static readonly Dictionary<string, string> s_attributes = new Dictionary<string, string>
        {
            { Intensity, AttributeNames.Intensity },
            { "colorRed", AttributeNames.Red },
            { "colorGreen", AttributeNames.Green },
            { "colorBlue", AttributeNames.Blue },
            { ReturnIndex, AttributeNames.ReturnNumber },
            { "returnCount", AttributeNames.NumberOfReturns },
            { "nor:normalX", AttributeNames.NormalX },
            { "nor:normalY", AttributeNames.NormalY },
            { "nor:normalZ", AttributeNames.NormalZ },
        };

        public static string AttributeOf(string field) =>
            s_attributes.TryGetValue(field, out string name) ? name : CommonNames.Of(field) ?? field;
    }

    // From the scanner's coordinates to the file's (ASTM E2807, 8.4.4).
    struct E57Pose
    {
        // The scanner's axes in the file's coordinates.
        public double3 AxisX;
        public double3 AxisY;
        public double3 AxisZ;
        public double3 Translation;
        public bool IsTranslation;

        public static E57Pose Identity => new E57Pose
        {
            AxisX = new double3(1, 0, 0),
            AxisY = new double3(0, 1, 0),
            AxisZ = new double3(0, 0, 1),
            IsTranslation = true,
        };

        public bool IsIdentity => IsTranslation && math.all(Translation == new double3(0, 0, 0));

        // problem: what was assumed instead, if the numbers are not a valid pose.
        public static E57Pose Read(E57Node node, out string problem)
        {
            var pose = Identity;
            problem = null;
            var translation = node?.Child("translation");
            if (translation != null)
            {
                pose.Translation = new double3(translation.NumberOf("x"), translation.NumberOf("y"), translation.NumberOf("z"));
                if (!math.all(math.isfinite(pose.Translation)))
                {
                    pose.Translation = new double3(0, 0, 0);
                    problem = "the pose's translation is no three numbers: 0, 0, 0 is assumed";
                }
            }
            var rotation = node?.Child("rotation");
            if (rotation == null)
                return pose;
            double w = rotation.NumberOf("w"), x = rotation.NumberOf("x"), y = rotation.NumberOf("y"), z = rotation.NumberOf("z");
            double lengthSq = w * w + x * x + y * y + z * z;
            if (!(lengthSq > 1e-6) || double.IsInfinity(lengthSq))
            {
                problem = "the pose's rotation is no quaternion: no rotation is assumed";
                return pose;
            }
            if (Math.Abs(lengthSq - 1) > 1e-3)
                problem = "the pose's quaternion has a length of " + NumberText.Of(Math.Sqrt(lengthSq)) + ": it is scaled to 1";
            if (x == 0 && y == 0 && z == 0)
                return pose;
            double s = 2 / lengthSq;
            pose.IsTranslation = false;
            pose.AxisX = new double3(1 - s * (y * y + z * z), s * (x * y + w * z), s * (x * z - w * y));
            pose.AxisY = new double3(s * (x * y - w * z), 1 - s * (x * x + z * z), s * (y * z + w * x));
            pose.AxisZ = new double3(s * (x * z + w * y), s * (y * z - w * x), 1 - s * (x * x + y * y));
            return pose;
        }
    }
}
