namespace FastPoints.HostTests.Remote;

sealed class LateReadTests : RemoteFixture
{
    [TearDown]
    public void UseSockets() => RangeExchange.CreateHandler = null;

    // Some runtimes' streams go on with a read that was given up, and write when they can.
    [Test]
    public void Read_GivenUpThatEndsLater_WritesNothing()
    {
        byte[] bytes = Make("a.bin", 200_000);
        Action writeLate = null;
        int answers = 0;
        RangeExchange.CreateHandler = () => new Handler(range => Interlocked.Increment(ref answers) switch
        {
            1 => new Body((_, into, offset, count, done) =>
            {
                Copy(0, into, offset, count);
                done(count);
            }),
            2 => new Body((_, into, offset, count, done) => writeLate = () =>
            {
                Array.Fill(into, (byte)0xEE, offset, count);
                done(count);
            }),
            _ => new Body((at, into, offset, count, done) =>
            {
                if (at > 0)
                    writeLate();
                count = Math.Min(count, 10_000);
                Copy(100_000 + at, into, offset, count);
                done(count);
            }),
        }, bytes.Length);
        void Copy(int at, byte[] into, int offset, int count) => Array.Copy(bytes, at, into, offset, count);
        CloseClient();

        var file = RemoteFile.Open(Server.Of("a.bin"));
        byte[] read = Read(file, 100_000, 30_000);

        Assert.That(answers, Is.EqualTo(3));
        Assert.That(read, Is.EqualTo(bytes[100_000..130_000]));
    }

    sealed class Handler : HttpMessageHandler
    {
        readonly Func<RangeItemHeaderValue, Stream> m_answer;
        readonly long m_length;

        public Handler(Func<RangeItemHeaderValue, Stream> answer, long length) => (m_answer, m_length) = (answer, length);

        protected override Task<HttpResponseMessage> SendAsync(HttpRequestMessage request, CancellationToken ends)
        {
            RangeItemHeaderValue range = request.Headers.Range.Ranges.Single();
            var answer = new HttpResponseMessage(HttpStatusCode.PartialContent) { Content = new StreamContent(m_answer(range)) };
            answer.Content.Headers.ContentRange = new ContentRangeHeaderValue(range.From.Value, range.To.Value, m_length);
            return Task.FromResult(answer);
        }
    }

    delegate void ReadBody(int at, byte[] into, int offset, int count, Action<int> done);

    // Reads as it is told, when it is told.
    sealed class Body : Stream
    {
        readonly ReadBody m_read;
        int m_at;

        public Body(ReadBody read) => m_read = read;

        public override Task<int> ReadAsync(byte[] into, int offset, int count, CancellationToken ends)
        {
            var done = new TaskCompletionSource<int>();
            m_read(m_at, into, offset, count, bytes =>
            {
                m_at += bytes;
                done.TrySetResult(bytes);
            });
            return done.Task;
        }

        public override bool CanRead => true;
        public override bool CanSeek => false;
        public override bool CanWrite => false;
        public override long Length => throw new NotSupportedException();
        public override long Position { get => throw new NotSupportedException(); set => throw new NotSupportedException(); }
        public override void Flush() { }
        public override int Read(byte[] into, int offset, int count) => throw new NotSupportedException();
        public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();
        public override void SetLength(long length) => throw new NotSupportedException();
        public override void Write(byte[] from, int offset, int count) => throw new NotSupportedException();
    }
}
