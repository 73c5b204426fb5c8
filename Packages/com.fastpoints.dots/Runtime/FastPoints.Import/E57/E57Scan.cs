using System.Collections.Generic;
using FastPoints.Core;
using Unity.Mathematics;

namespace FastPoints.E57
{
    sealed class E57Scan
    {
        // More bytestreams than any real prototype has.
        public const int MaxFields = 250;

        // In the file: scans that cannot be read are missing in the list.
        public int Index;
        public string Name;
        public ulong RecordsClaimed;

        // Physical, of its binary section.
        public ulong SectionOffset;

        public readonly List<E57Field> Fields = new List<E57Field>();
        public E57Pose Pose = E57Pose.Identity;

        // In the scanner's own coordinates; empty if the file does not say.
        public BoundsGeo BoundsClaimed = BoundsGeo.Empty;

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
        public E57Field[] Three(string[] names)
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

        public bool IsCartesian => Three(E57Names.Cartesian) != null;

        public string Label => "scan " + NumberText.Of(Index + 1L);

        // In all bytestreams that are read.
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
            return IsCartesian || Three(E57Names.Spherical) != null
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
}
