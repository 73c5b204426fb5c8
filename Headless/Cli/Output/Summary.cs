namespace FastPoints.Cli.Output;

public static class Summary
{
    const long LargestExact = 1L << 53; // Beyond this a double no longer holds every integer, and readers of JSON would round.

    /// <summary>Version of the schema of all summaries: keys are added and never removed.</summary>
    public const int Version = 1;

    static readonly JsonWriterOptions s_options =
        new() { Indented = true, Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };

    public static void Write(string destination, TextWriter output, string verb, CliRun run, Failure? failure)
    {
        byte[] bytes = ToBytes(json =>
        {
            json.WriteString("verb", verb);
            json.WriteNumber("schema", Version);
            json.WriteArray("inputs", run.Inputs, json.WriteStringValue);
            run.WriteKeys?.Invoke(json);
            run.Points.WriteKeys(json);
            if (run.Inputs.Any(SourcePath.IsRemote))
                WriteRemote(json);
            json.WriteNumber("seconds", Math.Round(run.Seconds, 6));
            json.WriteArray("stages", run.Progress.Finished, stage => WriteStage(json, stage));
            json.WriteInteger("peakResidentBytes", PeakMemory.ResidentBytes);
            json.WriteArray("warnings", run.Warnings, json.WriteStringValue);
            if (failure != null)
                WriteFailure(json, failure);
        });
        if (destination == "-")
            OutputFile.WithFileErrors("standard output", () =>
            {
                output.WriteLine(Encoding.UTF8.GetString(bytes));
                output.Flush();
            });
        else
            OutputFile.Write(destination, bytes);
    }

    static void WriteRemote(Utf8JsonWriter json)
    {
        json.WriteInteger("requests", RemoteStatistics.Requests);
        json.WriteInteger("bytesFetched", RemoteStatistics.BytesFetched);
        json.WriteInteger("bytesUnused", RemoteStatistics.BytesUnused);
        json.WriteInteger("cacheHits", RemoteStatistics.CacheHits);
    }

    public static void WriteJsonFile(string path, Action<Utf8JsonWriter> keys) => OutputFile.Write(path, ToBytes(keys));

    static byte[] ToBytes(Action<Utf8JsonWriter> keys)
    {
        var bytes = new ArrayBufferWriter<byte>(4096);
        using (var json = new Utf8JsonWriter(bytes, s_options))
        {
            json.WriteStartObject();
            keys(json);
            json.WriteEndObject();
        }
        return bytes.WrittenSpan.ToArray();
    }

    static void WriteStage(Utf8JsonWriter json, StageProgress.Stage stage)
    {
        json.WriteStartObject();
        json.WriteString("name", stage.Name);
        json.WriteNumber("seconds", Math.Round(stage.Seconds, 6));
        json.WriteInteger("points", stage.Points);
        json.WriteInteger("bytes", stage.Bytes);
        json.WriteEndObject();
    }

    public static void WriteFailure(Utf8JsonWriter json, Failure failure)
    {
        json.WriteStartObject("failure");
        json.WriteString("code", failure.Code);
        json.WriteString("message", failure.Message);
        json.WriteString("file", failure.File);
        if (failure.Offset >= 0)
            json.WriteInteger("offset", failure.Offset);
        else
            json.WriteNull("offset");
        json.WriteEndObject();
    }

    /// <summary>A number, or a decimal string where a double would not hold it.</summary>
    public static void WriteInteger(this Utf8JsonWriter json, string key, long value)
    {
        if (Math.Abs(value) <= LargestExact)
            json.WriteNumber(key, value);
        else
            json.WriteString(key, value.ToString(CultureInfo.InvariantCulture));
    }

    public static void WriteInteger(this Utf8JsonWriter json, string key, ulong value)
    {
        if (value <= (ulong)LargestExact)
            json.WriteNumber(key, value);
        else
            json.WriteString(key, value.ToString(CultureInfo.InvariantCulture));
    }

    /// <summary>A number; null if it is not finite, which JSON cannot say.</summary>
    public static void WriteReal(this Utf8JsonWriter json, string key, double value)
    {
        if (double.IsFinite(value))
            json.WriteNumber(key, value);
        else
            json.WriteNull(key);
    }

    public static void WriteArray<T>(this Utf8JsonWriter json, string key, IEnumerable<T> values, Action<T> write)
    {
        json.WriteStartArray(key);
        foreach (T value in values)
            write(value);
        json.WriteEndArray();
    }

    /// <summary>An array of objects, of each of which the members are written.</summary>
    public static void WriteObjects<T>(this Utf8JsonWriter json, string key, IEnumerable<T> values, Action<T> writeMembers) =>
        json.WriteArray(key, values, value =>
        {
            json.WriteStartObject();
            writeMembers(value);
            json.WriteEndObject();
        });

    /// <summary>An array in an array.</summary>
    public static void WriteNumbers(this Utf8JsonWriter json, params ReadOnlySpan<long> numbers)
    {
        json.WriteStartArray();
        foreach (long number in numbers)
            json.WriteNumberValue(number);
        json.WriteEndArray();
    }

    public static void WriteVector(this Utf8JsonWriter json, string key, double3 value)
    {
        json.WriteStartArray(key);
        for (int axis = 0; axis < 3; axis++)
        {
            if (double.IsFinite(value[axis]))
                json.WriteNumberValue(value[axis]);
            else
                json.WriteNullValue();
        }
        json.WriteEndArray();
    }

    /// <summary>An object with min and max; null for an empty box.</summary>
    public static void WriteBounds(this Utf8JsonWriter json, string key, BoundsGeo bounds)
    {
        if (bounds.IsEmpty)
        {
            json.WriteNull(key);
            return;
        }
        json.WriteStartObject(key);
        json.WriteVector("min", bounds.Min);
        json.WriteVector("max", bounds.Max);
        json.WriteEndObject();
    }
}
