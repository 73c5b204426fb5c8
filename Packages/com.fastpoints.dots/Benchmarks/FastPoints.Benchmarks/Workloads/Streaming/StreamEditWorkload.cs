using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Threading;
using FastPoints.Export;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Collections;

namespace FastPoints.Benchmarks
{
    /// <summary>An edit of a cloud that is shown, until it is shown as edited; then it is undone. A box deletes half of the
    /// cloud, five million points being shown; or a brush of 20 balls hides points in the middle of a million, or shows them ball
    /// after ball as the Scene view's does, with nothing written.</summary>
    sealed class StreamEditWorkload : IWorkload
    {
        const long PoolBytes = 1L << 30;
        const int Balls = 20;

        readonly bool m_isBrush, m_isStroke;
        string m_path;
        NativeArray<StreamView> m_views;
        StreamContext m_stream;
        CloudVersions m_versions;
        double m_longestMs;

        StreamEditWorkload(bool isBrush, bool isStroke) => (m_isBrush, m_isStroke) = (isBrush, isStroke);

        public static IEnumerable<IWorkload> All() => new[]
        {
            new StreamEditWorkload(false, false), new StreamEditWorkload(true, false), new StreamEditWorkload(true, true),
        };

        public string Name => m_isStroke ? "stream edit stroke" : m_isBrush ? "stream edit brush" : "stream edit box";
        public string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            m_path = TerrainBenchmarkFile.MakeConverted(context);
            File.Delete(EditJournal.PathOf(m_path));
            m_views = new NativeArray<StreamView>(1, Allocator.Persistent) { [0] = StreamView.Everything(1) };
            m_stream = new StreamContext(new MemoryNodePool(PoolBytes, 8 << 20));
            m_stream.Settings.Selection = new LodSettings { PointBudget = m_isBrush ? 1_000_000 : 5_000_000, Hysteresis = 1 };
            m_versions = new CloudVersions(m_stream);
            m_versions.Add(Open());
            while (!FrameStep.Run(m_stream, m_views).IsSettled)
                Thread.Yield();
        }

        public WorkloadResult Run()
        {
            m_longestMs = 0;
            var operation = NewOperation();
            var watch = Stopwatch.StartNew();
            for (int balls = 1; m_isStroke && balls <= Balls; balls++)
            {
                var draft = new EditOperation { Action = EditAction.Color, Value = new byte[] { 255, 128, 0 } };
                draft.Balls.AddRange(operation.Balls.GetRange(0, balls));
                Show(draft);
            }
            if (m_isStroke)
                return new WorkloadResult
                {
                    Points = Balls,
                    Note = "a ball is shown after " + NumberText.Of(Math.Round(watch.Elapsed.TotalMilliseconds / Balls)) +
                        " ms; longest frame of the main thread " + NumberText.Of(Math.Round(m_longestMs, 1)) + " ms",
                };
            JobCoroutine.RunToEnd(EditCloud.Run(m_path, operation, null));
            double counted = watch.Elapsed.TotalMilliseconds;
            Show();
            double shown = watch.Elapsed.TotalMilliseconds;
            EditCloud.GoTo(m_path, 0);
            Show();
            double undone = watch.Elapsed.TotalMilliseconds;
            return new WorkloadResult
            {
                Points = operation.PointsChanged,
                Note = string.Format(CultureInfo.InvariantCulture, "{0:N0} points: written down after {1:0} ms, shown after " +
                    "{2:0} ms; undone and shown in {3:0} ms; longest frame of the main thread {4:0.0} ms",
                    operation.PointsChanged, counted, shown, undone - shown, m_longestMs),
            };
        }

        public void Dispose()
        {
            m_stream?.Dispose();
            if (m_views.IsCreated)
                m_views.Dispose();
            if (m_path != null)
                File.Delete(EditJournal.PathOf(m_path));
        }

        FolderSource Open(EditOperation draft = null)
        {
            var source = new FolderSource(CloudFolder.Open(m_path), StoreLayout.ColorName);
            source.Edits = EditPlan.Of(m_path, source.Folder.Manifest, draft);
            return source;
        }

        void Show(EditOperation draft = null)
        {
            var source = Open(draft); // By another thread, in scenes.
            long start = Stopwatch.GetTimestamp();
            m_versions.Add(source);
            for (bool isShown = false; !isShown; Thread.Yield(), start = Stopwatch.GetTimestamp())
            {
                FrameStep.Run(m_stream, m_views);
                isShown = m_versions.Update();
                m_longestMs = Math.Max(m_longestMs, (Stopwatch.GetTimestamp() - start) * 1000.0 / Stopwatch.Frequency);
            }
        }

        EditOperation NewOperation()
        {
            var manifest = ((FolderSource)m_stream.Clouds[m_versions.ShownNumber].Source).Folder.Manifest;
            Grid3 min = manifest.BoundsMin, size = manifest.BoundsMax - min;
            var operation = new EditOperation { Action = m_isBrush ? EditAction.Hide : EditAction.Delete };
            if (!m_isBrush)
            {
                operation.Boxes.Add(new EditShape { A = min, B = min + new Grid3(size.X / 2, size.Y, size.Z) });
                return operation;
            }
            long radius = size.X / 40;
            for (int i = 0; i < Balls; i++)
                operation.Balls.Add(new EditShape
                {
                    A = min + new Grid3(size.X / 4 + size.X * i / 40, size.Y / 2, size.Z / 2),
                    B = new Grid3(radius, radius, radius),
                    IsBall = true,
                });
            return operation;
        }
    }
}
