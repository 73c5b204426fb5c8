using System;
using System.Collections.Generic;

namespace FastPoints.Benchmarks
{
    static class ReadingWorkloads
    {
        public static IEnumerable<IWorkload> All()
        {
            yield return new ColumnsWorkload("las columns", "las read and copy", LasBenchmarkFile.Make, LasBenchmarkFile.Wanted);
            yield return new PlainPassWorkload("las read and copy", null, LasBenchmarkFile.Make, LasBenchmarkFile.RecordBytes);

            yield return new ColumnsWorkload("ply ascii", null, context => PlyBenchmarkFile.Make(context, true));
            yield return new ColumnsWorkload("ply binary", "ply read and copy", PlyBinary);
            yield return PlyPointers();
            yield return new PlainPassWorkload("ply read and copy", null, PlyBinary, PlyBenchmarkFile.RecordBytes);

            yield return new ColumnsWorkload("xyz text", null, XyzBenchmarkFile.Make);

            yield return new ColumnsWorkload("e57 columns", "e57 read and copy", E57BenchmarkFile.Make);
            yield return new PlainPassWorkload("e57 read and copy", null, E57BenchmarkFile.Make, E57BenchmarkFile.BytesPerPoint);

            var laz = Sample(BenchmarkSamples.LazLayered);
            yield return new ColumnsWorkload("laz layered", "laz layered read and copy", laz);
            yield return new ColumnsWorkload("laz layered positions and colours", "laz layered read and copy", laz,
                LasBenchmarkFile.Wanted);
            yield return new ColumnsWorkload("laz layered positions", "laz layered read and copy", laz,
                schema => schema.Select(AttributeNames.X, AttributeNames.Y, AttributeNames.Z));
            yield return new ReadCopyWorkload("laz layered read and copy", laz);

            yield return new ExportWorkload("export las", "laz layered", laz, ".las");
            yield return new ExportWorkload("export laz layered", "laz layered", laz, ".laz");
            yield return new ExportWorkload("export laz pointwise", "laz pointwise", Sample(BenchmarkSamples.LazPointwise),
                ".laz");

            foreach (var (name, find) in new (string, Func<WorkloadContext, string>)[]
            {
                ("laz pointwise", Sample(BenchmarkSamples.LazPointwise)),
                ("potree default", Sample(BenchmarkSamples.PotreeDefault)),
                ("potree brotli", Sample(BenchmarkSamples.PotreeBrotli)),
                ("ept binary", context => EptBenchmarkFolder.Make(context, false)),
                ("ept laszip", context => EptBenchmarkFolder.Make(context, true)),
            })
            {
                yield return new ColumnsWorkload(name, name + " read and copy", find);
                yield return new ReadCopyWorkload(name + " read and copy", find);
            }
        }

        static unsafe IWorkload PlyPointers() => new PlainPassWorkload("ply pointers", "ply read and copy", PlyBinary,
            PlyBenchmarkFile.RecordBytes, PlyBenchmarkFile.Decode);

        static string PlyBinary(WorkloadContext context) => PlyBenchmarkFile.Make(context, false);

        static Func<WorkloadContext, string> Sample(string name) => context => BenchmarkSamples.Find(context, name);
    }
}
