using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Picture;
using FastPoints.Reading;
using FastPoints.Sources;
using FastPoints.Store;
using UnityEngine;
using UnityEngine.Experimental.Rendering;

namespace FastPoints.Editor
{
    /// <summary>Draws small pictures of clouds with jobs, one slice in each update, and keeps them where the converted clouds are
    /// or would be. Files are drawn from the first wave of a preview, converted clouds from the top of their octrees. Main
    /// thread; it draws one at a time while the others wait.</summary>
    internal sealed class CloudThumbnails : IDisposable
    {
        const string Extension = ".preview.png";

        readonly Queue<string> m_order = new Queue<string>();
        readonly Dictionary<string, string[]> m_waiting = new Dictionary<string, string[]>();
        PoolTask<ThumbnailDrawing> m_opening;
        ThumbnailDrawing m_drawing;
        PoolTask<string> m_writing;
        string m_current;
        public event Action<string> Drawn; // Raised with a cloud's folder when its picture was written.

        public bool IsDrawing => m_current != null || m_waiting.Count > 0;

        public static string PathOf(string cloud) => Path.ChangeExtension(cloud.TrimEnd('/', '\\'), null) + Extension;

        public void Add(string cloud) => Add(cloud, null);

        /// <summary>Draws the files that a cloud will or could be converted from.</summary>
        public void AddFiles(string cloud, IEnumerable<string> sources) => Add(cloud, new List<string>(sources).ToArray());

        public void Update(double budgetMs)
        {
            if (m_current == null && m_waiting.Count > 0)
                Begin();
            if (m_current == null)
                return;
            string cloud = m_current;
            try
            {
                if (m_writing != null)
                    EndWriting();
                else if (m_opening != null)
                    EndOpening();
                else if (m_drawing.Coroutine.Tick(budgetMs))
                    BeginWriting();
            }
            catch (Exception e)
            {
                // Opening a damaged cloud reports its failure; a cloud whose folder cannot be written has no picture.
                var failure = PointCloudException.Of(cloud, e);
                End();
                if (failure.Code == FailureCode.Unexpected)
                    Debug.LogError("FastPoints: no picture of " + failure.FullMessage);
            }
        }

        /// <summary>Waits for a picture being written, some ten kilobytes, and for a header being read.</summary>
        public void Dispose()
        {
            m_waiting.Clear();
            m_order.Clear();
            m_drawing ??= m_opening?.TakeOrDefault();
            m_writing?.TakeOrDefault();
            End();
        }

        /// <summary>Adds a cloud; a later request replaces a waiting one.</summary>
        void Add(string cloud, string[] sources)
        {
            if (!m_waiting.ContainsKey(cloud))
                m_order.Enqueue(cloud);
            m_waiting[cloud] = sources;
        }

        void Begin()
        {
            string cloud = m_current = m_order.Dequeue();
            var sources = m_waiting[cloud];
            m_waiting.Remove(cloud);
            m_opening = PoolTask.Begin(cloud,
                () => sources == null ? ThumbnailDrawing.OfCloud(cloud) : ThumbnailDrawing.OfFiles(sources));
        }

        void EndOpening()
        {
            if (!m_opening.IsDone)
                return;
            var opening = m_opening;
            m_opening = null;
            m_drawing = opening.Take();
        }

        void BeginWriting()
        {
            var image = m_drawing.Image;
            string path = PathOf(m_current);
            m_writing = PoolTask.Begin(path, () => Write(path, image));
        }

        void EndWriting()
        {
            if (!m_writing.IsDone)
                return;
            var writing = m_writing;
            string cloud = m_current;
            m_writing = null;
            End();
            writing.Take();
            Drawn?.Invoke(cloud);
        }

        void End()
        {
            m_drawing?.Dispose();
            (m_opening, m_drawing, m_current, m_writing) = (null, null, null, null);
        }

        static string Write(string path, RgbaImage image)
        {
            string temporary = path + ".tmp";
            try
            {
                Directory.CreateDirectory(Path.GetDirectoryName(path));
                File.WriteAllBytes(temporary, ImageConversion.EncodeArrayToPNG(image.RgbaFromBottom(),
                    GraphicsFormat.R8G8B8A8_SRGB, (uint)image.Width, (uint)image.Height));
                FileChanges.Retry(() => FileChanges.Replace(temporary, path));
                return path;
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                throw FileFailures.WriteFailure(path, e);
            }
        }
    }

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
