using System.Collections.Generic;
using System.Text.Json;
using FastPoints.Files;
using FastPoints.Picture;
using FastPoints.Pipeline;
using FastPoints.Store;

namespace FastPoints.Cli
{
    /// <summary>A picture that was drawn from a source file or a converted cloud, and what is to be said of it.</summary>
    public sealed class DrawStep
    {
        public required long Points { get; init; }

        /// <summary>Nodes of the octree; null for a source file, which has none.</summary>
        public int? Nodes { get; init; }
        public required double Seconds { get; init; }
        public required RgbaImage Image { get; init; }
        public required byte[] Png { get; init; }
        public required IReadOnlyList<string> Assumptions { get; init; }

        /// <summary>Against another picture, where one was given.</summary>
        public ImageError? Error { get; set; }

        /// <param name="budget">Points to draw at most; 0 for all.</param>
        public static DrawStep Run(PointReader reader, PictureOptions options, long budget, CliRun run)
        {
            double begin = run.Seconds;
            var draw = new DrawCloud(reader, options, budget);
            run.Pump(draw.Run(run.Progress));
            run.Warn(reader.Info);
            return new DrawStep
            {
                Points = draw.PointsDrawn,
                Seconds = run.Seconds - begin,
                Image = draw.Image,
                Png = FastPoints.Picture.Png.Encode(draw.Image),
                Assumptions = draw.Plan.Assumptions,
            };
        }

        /// <summary>From a converted cloud.</summary>
        /// <param name="budget">Points to draw at most; 0 for the default.</param>
        public static DrawStep RunStored(string path, PictureOptions options, long budget, CliRun run)
        {
            double begin = run.Seconds;
            using var folder = CloudFolder.Open(path);
            var draw = new DrawStored(folder, options, budget);
            run.Pump(draw.Run(run.Progress));
            return new DrawStep
            {
                Points = draw.PointsDrawn,
                Nodes = draw.NodesDrawn,
                Seconds = run.Seconds - begin,
                Image = draw.Image,
                Png = FastPoints.Picture.Png.Encode(draw.Image),
                Assumptions = draw.Plan.Assumptions,
            };
        }

        public string Describe() => Human.Count(Points) + " points" + (Nodes is { } nodes ? " of " + Human.Count(nodes) + " nodes" : "")
            + " in " + Human.Seconds(Seconds);

        /// <summary>The keys of <c>picture</c> but for <c>seconds</c>, into an object that is open.</summary>
        public void WriteKeys(Utf8JsonWriter json)
        {
            json.WriteInteger("points", Points);
            if (Nodes is { } nodes)
                json.WriteInteger("nodes", nodes);
            else
                json.WriteNull("nodes");
            json.WriteString("device", "cpu, " + Threads.InUse + (Threads.InUse == 1 ? " thread" : " threads"));
            if (Error is not { } error)
                return;
            json.WriteReal("psnr", error.Psnr);
            json.WriteReal("ssim", error.Ssim);
            json.WriteReal("uncovered", error.Uncovered);
        }
    }
}
