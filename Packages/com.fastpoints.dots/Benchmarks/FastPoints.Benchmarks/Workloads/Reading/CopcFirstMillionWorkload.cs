using System;
using FastPoints.Reading;
using FastPoints.Sources;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Benchmarks
{
    public struct CopcFirstMillionWorkload : IWorkload
    {
        const int WantedPoints = 1_000_000;

        string m_path;

        public string Name => "copc first million";
        public string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            m_path = BenchmarkSamples.FindCopc(context);
            Run();
        }

        public WorkloadResult Run()
        {
            if (m_path == null)
                return default;
            using var reader = PointReaders.Open(m_path);
            int levels = 0;
            do
                JobCoroutine.RunToEnd(reader.ReadLevels(++levels));
            while (reader.PointCount < WantedPoints && reader.Tree.LevelCount >= levels);
            return ReadFirst(reader);
        }

        static WorkloadResult ReadFirst(PointReader reader)
        {
            var result = new WorkloadResult();
            int slots = SourceScan.SlotsFor(reader, reader.Info.Schema);
            var reads = new BlockRead[slots];
            try
            {
                for (int i = 0; i < slots; i++)
                    reads[i] = reader.CreateRead(reader.Info.Schema, reader.MaxPointsPerBlock, Allocator.Persistent);
                long wanted = 0;
                for (int block = 0; block < reader.BlockCount + slots; block++)
                {
                    var read = reads[block % slots];
                    if (block >= slots && read.Range.Count > 0)
                    {
                        read.Complete();
                        result.Points += read.Points.Count;
                        result.Bytes += reader.BytesOfRange(read.Range);
                    }
                    bool isWanted = block < reader.BlockCount && wanted < WantedPoints;
                    int count = isWanted ? (int)Math.Min(reader.PointsInBlock(block), WantedPoints - wanted) : 0;
                    read.Begin(new BlockRange(Math.Min(block, reader.BlockCount - 1), 0, count));
                    JobHandle.ScheduleBatchedJobs();
                    wanted += count;
                }
            }
            finally
            {
                foreach (var read in reads)
                    read?.Dispose();
            }
            return result;
        }

        public void Dispose() { }
    }
}
