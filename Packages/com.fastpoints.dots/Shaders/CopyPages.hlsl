// Copies pages of 1 KiB from where they were uploaded to into a bank of the pool: a group copies one.
#ifndef FASTPOINTS_COPY_PAGES_INCLUDED
#define FASTPOINTS_COPY_PAGES_INCLUDED

#define FASTPOINTS_PAGE_BYTES 1024u
#define FASTPOINTS_COPY_THREADS 64

ByteAddressBuffer _FastPointsStaging;

// By page to copy: its number in the staging buffer and in the bank.
StructuredBuffer<uint2> _FastPointsPages;
RWByteAddressBuffer _FastPointsBankOut;

// The first of the dispatch's pages.
uint _FastPointsFirstPage;

[numthreads(FASTPOINTS_COPY_THREADS, 1, 1)]
void FastPointsCopyPages(uint3 group : SV_GroupID, uint3 thread : SV_GroupThreadID)
{
    uint2 page = _FastPointsPages[_FastPointsFirstPage + group.x];
    uint at = thread.x * 16u;
    _FastPointsBankOut.Store4(page.y * FASTPOINTS_PAGE_BYTES + at, _FastPointsStaging.Load4(page.x * FASTPOINTS_PAGE_BYTES + at));
}

#endif
