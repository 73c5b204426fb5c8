using System;
using System.Collections.Generic;
using FastPoints.Picture;
using FastPoints.Sources;
using FastPoints.Store;

namespace FastPoints.Editor
{
    /// <summary>One small picture of a converted cloud, or of files that are not converted. It is opened on any thread, drawn and
    /// disposed on the main thread.</summary>
    sealed class ThumbnailDrawing : IDisposable
    {
        const long Budget = 200_000;

        public const int SizePx = 256;
        const int PreviewPoints = SizePx * SizePx; // Points in the first wave of files: about one a pixel.

        readonly IDisposable[] m_owned;
        readonly Func<RgbaImage> m_image;

        ThumbnailDrawing(IEnumerator<JobStep> work, Func<RgbaImage> image, params IDisposable[] owned)
        {
            m_image = image;
            m_owned = owned;
            Coroutine = new JobCoroutine(work);
        }

        public JobCoroutine Coroutine { get; }

        public RgbaImage Image => m_image();

        static PictureOptions Options => new PictureOptions { WidthPx = SizePx, HeightPx = SizePx, FramingPoints = 512 };

        /// <summary>Draws the top of the octree.</summary>
        /// <exception cref="PointCloudException">It cannot be read.</exception>
        public static ThumbnailDrawing OfCloud(string cloud)
        {
            var folder = CloudFolder.Open(cloud);
            var drawing = new DrawConvertedCloud(folder, Options, Budget) { PlansByManifest = true };
            return new ThumbnailDrawing(drawing.Run(null), () => drawing.Image, folder);
        }

        /// <summary>Draws the first wave of a preview, which reads little even of large files.</summary>
        /// <param name="sources">Files and folders that make one cloud.</param>
        /// <exception cref="PointCloudException">As <see cref="PointReaders"/> throws it.</exception>
        public static ThumbnailDrawing OfFiles(IReadOnlyList<string> sources)
        {
            var reader = PointReaders.Open(sources);
            var preview = new PreviewPicture(reader,
                new PreviewOptions { Points = PreviewPoints, Quick = true, Picture = Options });
            return new ThumbnailDrawing(preview.Run(null), () => preview.Image, preview, reader);
        }

        public void Dispose()
        {
            Coroutine.Cancel();
            foreach (var owned in m_owned)
                owned.Dispose();
        }
    }
}
