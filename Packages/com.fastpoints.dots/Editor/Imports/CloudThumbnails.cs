using System;
using System.Collections.Generic;
using System.IO;
using System.Threading.Tasks;
using FastPoints.Base;
using FastPoints.Files;
using FastPoints.Picture;
using FastPoints.Pipeline;
using FastPoints.Store;

namespace FastPoints.Editor
{
    /// <summary>
    /// Small pictures of converted clouds, drawn by jobs from the top of their octrees, a slice an update, and kept beside their
    /// folders. Main thread; one at a time, the others wait.
    /// </summary>
    public sealed class CloudThumbnails : IDisposable
    {
        /// <summary>Of each side.</summary>
        public const int SizePx = 256;

        /// <summary>Points of a picture at most.</summary>
        const long Budget = 200_000;
        const string Extension = ".preview.png";

        readonly List<string> m_waiting = new List<string>();
        CloudFolder m_folder;
        DrawStored m_drawing;
        WorkPump m_work;
        Task m_writing;
        string m_current;

        /// <summary>Gets a cloud's folder when its picture was written.</summary>
        public event Action<string> Drawn;

        public bool IsDrawing => m_current != null || m_waiting.Count > 0;

        /// <param name="cloud">The converted folder.</param>
        public static string PathOf(string cloud) =>
            Path.ChangeExtension(cloud.TrimEnd('/', '\\'), null) + Extension;

        /// <summary>Has a cloud drawn, finished or in the making.</summary>
        public void Add(string cloud)
        {
            if (!m_waiting.Contains(cloud))
                m_waiting.Add(cloud);
        }

        /// <summary>Once an update of the editor.</summary>
        public void Update(double budgetMs)
        {
            if (m_current == null && m_waiting.Count > 0)
                Begin();
            if (m_current == null)
                return;
            try
            {
                if (m_writing != null)
                    EndWriting();
                else if (m_work.Tick(budgetMs))
                    BeginWriting();
            }
            catch (PointCloudException)
            {
                // What ails the cloud is told by what opens it; one that is only not to be written beside has no picture.
                End();
            }
        }

        /// <summary>Waits for a picture that is being written: some ten kilobytes.</summary>
        public void Dispose()
        {
            m_waiting.Clear();
            try
            {
                m_writing?.Wait();
            }
            catch (AggregateException)
            {
                // A cloud without a picture.
            }
            End();
        }

        void Begin()
        {
            m_current = m_waiting[0];
            m_waiting.RemoveAt(0);
            try
            {
                m_folder = CloudFolder.Open(m_current);
                m_drawing = new DrawStored(m_folder, new PictureOptions { WidthPx = SizePx, HeightPx = SizePx }, Budget)
                {
                    PlansByManifest = true,
                };
                m_work = new WorkPump(m_drawing.Run(null));
            }
            catch (PointCloudException)
            {
                End();
            }
        }

        void BeginWriting()
        {
            var image = m_drawing.Image;
            string path = PathOf(m_current);
            m_writing = Task.Run(() => Write(path, image));
        }

        void EndWriting()
        {
            if (!m_writing.IsCompleted)
                return;
            var writing = m_writing;
            string cloud = m_current;
            m_writing = null;
            End();
            writing.GetAwaiter().GetResult();
            Drawn?.Invoke(cloud);
        }

        void End()
        {
            m_work?.Cancel();
            m_folder?.Dispose();
            (m_work, m_drawing, m_folder, m_current, m_writing) = (null, null, null, null, null);
        }

        static void Write(string path, RgbaImage image)
        {
            string temporary = path + ".tmp";
            Png.Write(temporary, image);
            try
            {
                if (File.Exists(path))
                    File.Replace(temporary, path, null);
                else
                    File.Move(temporary, path);
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                throw FileFailures.Writing(path, e);
            }
        }
    }
}
