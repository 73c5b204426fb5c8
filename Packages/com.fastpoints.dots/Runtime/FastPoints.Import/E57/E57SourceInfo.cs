using System.Collections.Generic;
using FastPoints.Reading;
using Unity.Mathematics;

namespace FastPoints.E57
{
    static class E57SourceInfo
    {
        // This many scans are listed in full, later ones with names and counts only.
        const int MaxScansDescribed = 50;
        const int MaxScansNamed = 1000;
        const int MaxImages = 50;
        const int MaxFieldsReported = 20;

        // Sensor, weather and times, as the standard names them.
        static readonly string[] s_texts =
        {
            "guid", "description", "sensorVendor", "sensorModel", "sensorSerialNumber", "sensorHardwareVersion",
            "sensorSoftwareVersion", "sensorFirmwareVersion",
        };
        static readonly string[] s_numbers = { "temperature", "relativeHumidity", "atmosphericPressure" };
        static readonly string[] s_times = { "acquisitionStart", "acquisitionEnd" };

        public static void AddFile(E57Node root, SourceInfo info)
        {
            if (root.TextOf("formatName") != "ASTM E57 3D Imaging Data File")
                info.Warn(-1, "formatName: wanted \"ASTM E57 3D Imaging Data File\", got \"" + root.TextOf("formatName") + "\"");
            info.AddFactIfAny("guid", root.TextOf("guid"));
            info.AddFactIfAny("library", root.TextOf("e57LibraryVersion"));
            var created = root.Child("creationDateTime");
            double seconds = created?.NumberOf("dateTimeValue") ?? 0;
            if (seconds > 0)
                info.AddFact("created", E57Text.GpsTime(seconds));
            AddCrs(root.Child("coordinateMetadata")?.Text, info);
            info.AddFact("scans", NumberText.Of(root.Child("data3D")?.Children.Count ?? 0));
            info.UnexportableFacts = "names, places and conditions of scans";
            AddImages(root.Child("images2D"), info);
            foreach (var child in root.Children)
                if (child.Name.IndexOf(':') >= 0)
                {
                    info.AddFact("extension (left out)", E57Text.OneLine(child.Name));
                    info.Losses.Add(new Loss(E57Text.OneLine(child.Name), info.Path, "it belongs to an extension"));
                }
        }

        public static void AddScan(E57Node node, E57Scan scan, SourceInfo info)
        {
            if (scan.Index >= MaxScansNamed)
                return;
            string label = scan.Label;
            string count = scan.RecordsClaimed.ToString(System.Globalization.CultureInfo.InvariantCulture) + " points";
            info.AddFact(label, scan.Name != null ? scan.Name + ", " + count : count);
            if (scan.Index >= MaxScansDescribed)
                return;
            foreach (string name in s_texts)
                info.AddFactIfAny("  " + name, node.TextOf(name));
            foreach (string name in s_numbers)
                if (node.Child(name) != null)
                    info.AddFact("  " + name, NumberText.Of(node.NumberOf(name)));
            foreach (string name in s_times)
                if (node.Child(name)?.NumberOf("dateTimeValue") > 0)
                    info.AddFact("  " + name, E57Text.GpsTime(node.Child(name).NumberOf("dateTimeValue")));
            AddPose(scan, info);
            if (!scan.BoundsClaimed.IsEmpty)
                info.AddFact("  cartesianBounds", NumberText.Of(scan.BoundsClaimed.Min) + " to " +
                    NumberText.Of(scan.BoundsClaimed.Max) +
                    " (the scanner's coordinates)");
            if (math.all(math.isfinite(scan.IntensityLimits)))
                info.AddFact("  intensityLimits", NumberText.Of(scan.IntensityLimits.x) + " to "
                    + NumberText.Of(scan.IntensityLimits.y));
            if (math.all(math.isfinite(scan.ColorLimits[0])))
                info.AddFact("  colorLimits",
                    NumberText.Of(scan.ColorLimits[0].x) + " to " + NumberText.Of(scan.ColorLimits[0].y) +
                    " (red)");
            var groups = node.Child("pointGroupingSchemes");
            if (groups != null && groups.Children.Count > 0)
            {
                info.AddFact("  pointGroupingSchemes", "left out");
                info.Losses.Add(new Loss("groups of points of " + label, info.Path, "points are kept one by one"));
            }
            foreach (var field in scan.Fields)
                info.AddFact("  field", E57Text.OneLine(field.Name) + ": " + field.Summary());
        }

        public static void AddSchema(E57Schema schema, List<E57Scan> scans, SourceInfo info)
        {
            info.AddFact("positions", schema.PositionSummary);
            if (schema.HasScaledColors)
                info.AddFact("colors", "scaled to 0 to 65,535 by their limits");
            if (info.Schema.Has(AttributeNames.ReturnNumber))
                info.AddFact("ReturnNumber", "returnIndex + 1: E57 counts returns from 0");
            for (int i = 0; i < schema.LeftOut.Count && i < MaxFieldsReported; i++)
                info.Warn(-1, "field " + E57Text.OneLine(schema.LeftOut[i]) + " is left out: another attribute has its name, " +
                    "or there are more than " + E57Scan.MaxFields);
            if (schema.LeftOut.Count > MaxFieldsReported)
                info.Warn(-1, NumberText.Of(schema.LeftOut.Count) + " fields are left out");
            AddMissing(scans, info);
            info.HasBoundsClaimed = scans.Count > 0;
            foreach (var scan in scans)
            {
                if (scan.RecordsClaimed == 0)
                    continue;
                info.HasBoundsClaimed &= scan.Pose.IsTranslation && !scan.BoundsClaimed.IsEmpty;
                info.BoundsClaimed.Include(new BoundsGeo(scan.BoundsClaimed.Min + scan.Pose.Translation,
                    scan.BoundsClaimed.Max + scan.Pose.Translation));
            }
            info.HasBoundsClaimed &= !info.BoundsClaimed.IsEmpty;
        }

        static void AddMissing(List<E57Scan> scans, SourceInfo info)
        {
            var scansWith = new Dictionary<string, int>();
            foreach (var scan in scans)
                foreach (var field in scan.Fields)
                {
                    string attribute = E57Names.AttributeOf(field.Name);
                    scansWith.TryGetValue(attribute, out int count);
                    scansWith[attribute] = count + 1;
                }
            int reported = 0;
            foreach (var attribute in info.Schema)
                if (scansWith.TryGetValue(attribute.Name, out int count) && count < scans.Count && reported++ < MaxFieldsReported)
                    info.Warn(-1, attribute.Name + " is there in " + count + " of " + scans.Count +
                        " scans: it is 0 in the points of the others");
        }

        static void AddPose(E57Scan scan, SourceInfo info)
        {
            var pose = scan.Pose;
            if (pose.IsIdentity)
                return;
            string text = "translation " + NumberText.Of(pose.Translation);
            if (!pose.IsTranslation)
                text += ", axes " + NumberText.Of(pose.AxisX) + " | " + NumberText.Of(pose.AxisY) + " | "
                    + NumberText.Of(pose.AxisZ);
            info.AddFact("  pose", text);
        }

        static void AddCrs(string metadata, SourceInfo info)
        {
            // Lengths are metres (ASTM E2807, 8.2). The text is free-form, by custom well-known text.
            info.Crs.MetresPerUnit = 1;
            if (string.IsNullOrWhiteSpace(metadata))
                return;
            double unit = info.Crs.MetresPerUnit;
            if (CrsText.Read(metadata, info.Crs))
                info.Crs.MetresPerUnit = info.Crs.MetresPerUnit == 0 ? unit : info.Crs.MetresPerUnit;
            else
                info.Crs.Name = E57Text.OneLine(metadata);
            info.AddFact("coordinateMetadata", E57Text.OneLine(metadata));
        }

        static void AddImages(E57Node images, SourceInfo info)
        {
            if (images == null || images.Children.Count == 0)
                return;
            info.AddFact("images (left out)", NumberText.Of(images.Children.Count));
            info.Losses.Add(new Loss(NumberText.Of(images.Children.Count) + " images", info.Path, "a cloud has points alone"));
            for (int i = 0; i < images.Children.Count && i < MaxImages; i++)
                info.AddFact("  image " + NumberText.Of(i + 1L), images.Children[i].TextOf("name") ??
                    images.Children[i].TextOf("guid") ?? "without a name");
        }
    }
}
