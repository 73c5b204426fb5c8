using System.Threading;
using FastPoints.Base;
using FastPoints.Picture;
using FastPoints.Pipeline;
using FastPoints.Points;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Collections;

namespace FastPoints.Cli
{
    /// <summary>A converted cloud before it is flown over: what colours it has, and what is streamed for them.</summary>
    public static class FlightCloud
    {
        /// <summary>Points of the upper levels that decide on colours and ranges.</summary>
        const int PointsToPlanWith = 100_000;

        /// <summary>Adds a cloud to a stream.</summary>
        /// <returns>What it looks like.</returns>
        public static PicturePlan Add(string path, StreamContext stream, PictureOptions options, CancellationToken cancellation,
            out DisplayRanges ranges, out int number)
        {
            var folder = CloudFolder.Open(path);
            try
            {
                var schema = LoadNodes.SchemaFor(folder, AttributeNames.Red, AttributeNames.Green, AttributeNames.Blue,
                    AttributeNames.Intensity, AttributeNames.Classification);
                var transform = folder.Manifest.Grid.FromCorner(folder.Manifest.Root.Corner);
                ranges = new DisplayRanges();
                using (var selection = new NodeSelection(folder))
                {
                    selection.Choose(null, 0, 0, PointsToPlanWith);
                    using var batch = new PointBatch(schema, checked((int)selection.Points), Allocator.Persistent);
                    WorkPump.RunToEnd(LoadNodes.Run(folder, selection, batch, null), cancellation);
                    WorkPump.RunToEnd(ranges.Measure(batch, transform, options.UpAxis), cancellation);
                }
                var plan = new PicturePlan(options, ranges, transform);
                var source = new FolderSource(folder, PlanesFor(plan.Mode));
                number = stream.Add(source, CloudPlacement.Geo(source.Grid, source.Root));
                return plan;
            }
            catch
            {
                folder.Dispose();
                throw;
            }
        }

        static string[] PlanesFor(ColorMode mode) => mode switch
        {
            ColorMode.Rgb => [StoreLayout.ColorName],
            ColorMode.Intensity => [AttributeNames.Intensity],
            ColorMode.Classification => [AttributeNames.Classification],
            _ => [],
        };
    }
}
