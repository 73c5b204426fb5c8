namespace StandIns.Graphics;

/// <summary>What the host asks of the device, in order: one recording is open at a time, a submission is a number, and what is no
/// longer wanted goes when the submissions that may use it have passed.</summary>
sealed unsafe class GpuQueue
{
    const int MaxInFlight = 32;

    readonly GpuDevice m_device;
    readonly Queue m_queue;
    readonly uint m_family;
    readonly VkSemaphore m_timeline;
    readonly Queue<GpuRecording> m_inFlight = new Queue<GpuRecording>();
    readonly Stack<GpuRecording> m_idle = new Stack<GpuRecording>();
    readonly Queue<(ulong Use, object Resource)> m_retired = new Queue<(ulong, object)>();
    GpuRecording m_open;
    ulong m_submitted;
    ulong m_done;

    internal GpuQueue(GpuDevice device, Queue queue, uint family)
    {
        m_device = device;
        m_queue = queue;
        m_family = family;
        var type = new SemaphoreTypeCreateInfo(semaphoreType: SemaphoreType.Timeline);
        var create = new SemaphoreCreateInfo(pNext: &type);
        VkSemaphore timeline;
        Check(Api.CreateSemaphore(device.Handle, &create, null, &timeline), "vkCreateSemaphore");
        m_timeline = timeline;
    }

    internal ulong Known { get; private set; }
    internal ulong NotBeyond { get; set; } = HeadlessGraphics.FramesBehind == 0 ? ulong.MaxValue : 0;
    internal ulong Next => m_submitted + 1;

    internal GpuRecording Open()
    {
        if (m_open != null)
            return m_open;
        if (m_inFlight.Count >= MaxInFlight)
            WaitFor(m_inFlight.Peek().Number);
        m_open = m_idle.Count > 0 ? m_idle.Pop() : new GpuRecording(m_device, m_family);
        m_open.Begin(Next);
        return m_open;
    }

    internal ulong Flush()
    {
        if (m_open == null)
            return m_submitted;
        GpuRecording recording = m_open;
        m_open = null;
        recording.End();
        var commands = new CommandBufferSubmitInfo(commandBuffer: recording.Commands);
        var signal = new SemaphoreSubmitInfo(semaphore: m_timeline, value: recording.Number,
            stageMask: PipelineStageFlags2.AllCommandsBit);
        var submit = new SubmitInfo2(commandBufferInfoCount: 1, pCommandBufferInfos: &commands, signalSemaphoreInfoCount: 1,
            pSignalSemaphoreInfos: &signal);
        Check(Api.QueueSubmit2(m_queue, 1, &submit, default), "vkQueueSubmit2");
        m_submitted = recording.Number;
        m_inFlight.Enqueue(recording);
        return m_submitted;
    }

    internal bool HasPassed(ulong number)
    {
        if (number > Known && number <= NotBeyond)
        {
            ulong value;
            Check(Api.GetSemaphoreCounterValue(m_device.Handle, m_timeline, &value), "vkGetSemaphoreCounterValue");
            SetDone(value);
            Known = Math.Max(Known, Math.Min(value, number));
        }
        return number <= Known;
    }

    internal void Await(ulong number)
    {
        if (number > m_submitted)
            Flush();
        number = Math.Min(number, m_submitted);
        if (number <= Known)
            return;
        WaitFor(number);
        Known = number;
    }

    void WaitFor(ulong number)
    {
        VkSemaphore timeline = m_timeline;
        var wait = new SemaphoreWaitInfo(semaphoreCount: 1, pSemaphores: &timeline, pValues: &number);
        Check(Api.WaitSemaphores(m_device.Handle, &wait, ulong.MaxValue), "vkWaitSemaphores");
        SetDone(number);
    }

    internal void Retire(object resource)
    {
        m_retired.Enqueue((m_open != null ? Next : m_submitted, resource));
        Collect();
    }

    void SetDone(ulong number)
    {
        m_done = Math.Max(m_done, number);
        while (m_inFlight.Count > 0 && m_inFlight.Peek().Number <= m_done)
            m_idle.Push(m_inFlight.Dequeue());
        Collect();
    }

    void Collect()
    {
        while (m_retired.Count > 0 && m_retired.Peek().Use <= m_done)
            Destroy(m_retired.Dequeue().Resource);
    }

    void Destroy(object resource)
    {
        if (resource is GpuBuffer buffer)
            buffer.Destroy(m_device);
        else
            ((GpuImage)resource).Destroy(m_device);
    }
}
